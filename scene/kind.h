#pragma once
#include <span>
#include <string>
#include <string_view>

/// What sort of thing an object is, from whatever its maker called it: one vocabulary for all formats and for the house
/// rules.
namespace inhabit::scene {

/// How things of a kind relate to the room.
enum class KindTrait {
  furniture,  ///< stands on the floor
  building,   ///< part of the building: never moves
  flat,       ///< lies on the floor and is walked on: collides with nothing
  wall,       ///< hangs on a wall
  ceiling,    ///< hangs from the ceiling
  small       ///< stands on other things
};

struct KindRow {
  std::string_view kind;
  KindTrait trait;
  /// Phrases in lower-case words, separated by `|`; one of them must occur word by word.
  std::string_view phrases;
};

/// Every kind; the first row that matches wins, so that "bedside table" stands before "bed" and "table".
std::span<const KindRow> kind_table();

/// The row of a normalised kind; nullptr when it is none.
const KindRow* find_kind(std::string_view kind);

/// The kind of a thing by its name ("Bedside table", "Dining_Table_16_2", "TVStand", "eTeks#kitchenUpperCabinet"):
/// words are split at case changes, digits and punctuation. "" when no row matches.
std::string_view kind_of(std::string_view name);
/// By its name, else by its catalogue id; a "table" no higher than 0.55 m is a "coffee table".
std::string_view kind_of(std::string_view name, std::string_view catalog_id, double height);

/// Lower-case words joined by `separator`, without digits: "Round_Table_2" gives "round-table".
std::string words_of(std::string_view name, char separator);

}  // namespace inhabit::scene
