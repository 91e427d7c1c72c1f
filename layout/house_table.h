#pragma once
#include <array>
#include <string_view>

#include "scene/scene.h"

/// What the house rules know: one row per wish.
namespace inhabit::layout {
using namespace scene;

/// A thing's own wishes: its back at a wall or not, and free depth at its faces (front, back, left, right), metres.
struct Stand {
  std::string_view kind;
  bool wall = false;
  Clearance clearance;
};

inline constexpr std::array kStands = {
    Stand{"bed", true, {0.4, 0, 0, 0}},
    Stand{"bunk bed", true, {0.4, 0, 0, 0}},
    Stand{"wardrobe", true, {0.6, 0, 0, 0}},
    Stand{"dresser", true, {0.6, 0, 0, 0}},
    Stand{"chest", true, {0.4, 0, 0, 0}},
    Stand{"bookcase", true, {0.5, 0, 0, 0}},
    Stand{"cupboard", true, {0.5, 0, 0, 0}},
    Stand{"filing cabinet", true, {0.5, 0, 0, 0}},
    Stand{"desk", true, {0.6, 0, 0, 0}},
    Stand{"dressing table", true, {0.5, 0, 0, 0}},
    Stand{"sofa", true, {0.4, 0, 0, 0}},
    Stand{"tv stand", true, {0.5, 0, 0, 0}},
    Stand{"kitchen cabinet", true, {0.6, 0, 0, 0}},
    Stand{"counter", true, {0.6, 0, 0, 0}},
    Stand{"fridge", true, {0.6, 0, 0, 0}},
    Stand{"cooker", true, {0.6, 0, 0, 0}},
    Stand{"dishwasher", true, {0.6, 0, 0, 0}},
    Stand{"washing machine", true, {0.6, 0, 0, 0}},
    Stand{"chest freezer", true, {0.5, 0, 0, 0}},
    Stand{"sink", true, {0.6, 0, 0, 0}},
    Stand{"kitchen island", false, {0.6, 0, 0, 0}},
    Stand{"washbasin", true, {0.5, 0, 0, 0}},
    Stand{"toilet", true, {0.5, 0, 0, 0}},
    Stand{"bidet", true, {0.5, 0, 0, 0}},
    Stand{"bath", true, {0, 0, 0, 0}},
    Stand{"shower", true, {0.4, 0, 0, 0}},
    Stand{"piano", true, {0.6, 0, 0, 0}},
    Stand{"aquarium", true, {0.3, 0, 0, 0}},
    Stand{"coat rack", true, {0.3, 0, 0, 0}},
    Stand{"floor lamp", true, {}},
    Stand{"plant", true, {}},
    Stand{"trash can", true, {}},
    Stand{"upper cabinet", true, {}},
    Stand{"hood", true, {}},
    Stand{"radiator", true, {}},
    Stand{"mirror", true, {}},
    Stand{"picture", true, {}},
    Stand{"shelf", true, {}},
    Stand{"wall lamp", true, {}},
    Stand{"curtain", true, {}},
    Stand{"toilet paper", true, {}},
    Stand{"tv", true, {}},
};

/// How a thing seeks another one out.
enum class Bond {
  around,  ///< a seat at its edge, on any side
  front,   ///< a seat at its front
  flank,   ///< beside its back end, looking the same way
  before,  ///< in front of its middle
  wing,    ///< before one of its ends, looking across
  circle,  ///< somewhere at its edge, looking at it
  view     ///< looks at it from a distance
};
struct Seek {
  std::string_view kind, other;
  Bond bond = Bond::around;
  std::size_t at_most = 100;  ///< so many to one of the others
  double gap = 0.03;          ///< between the two, metres (seats and `before`)
  bool turned = false;        ///< looks back at it (`before`)
};

/// In order of preference: a chair takes the first row whose other exists and has room.
inline constexpr std::array kSeeks = {
    Seek{"office chair", "desk", Bond::front, 1},
    Seek{"bench", "dining table", Bond::around, 2},
    Seek{"bench", "table", Bond::around, 2},
    Seek{"chair", "dining table", Bond::around, 8},
    Seek{"chair", "table", Bond::around, 6},
    Seek{"chair", "desk", Bond::front, 1},
    Seek{"chair", "dressing table", Bond::front, 1},
    Seek{"office chair", "table", Bond::front, 1},
    Seek{"office chair", "dining table", Bond::front, 1},
    Seek{"piano bench", "piano", Bond::front, 1},
    Seek{"stool", "piano", Bond::front, 1},
    Seek{"stool", "counter", Bond::front, 6},
    Seek{"stool", "kitchen island", Bond::front, 6},
    Seek{"stool", "dressing table", Bond::front, 1},
    Seek{"stool", "dining table", Bond::around, 4},
    Seek{"stool", "table", Bond::around, 4},
    Seek{"chair", "kitchen island", Bond::around, 6},
    Seek{"coffee table", "sofa", Bond::before, 1, 0.4},
    Seek{"sofa", "tv", Bond::view, 1},
    Seek{"sofa", "tv stand", Bond::view, 1},
    Seek{"sofa", "coffee table", Bond::before, 1, 0.4, true},
    Seek{"armchair", "sofa", Bond::wing, 2},
    Seek{"armchair", "coffee table", Bond::around, 4, 0.35},
    Seek{"armchair", "tv", Bond::view, 1},
    Seek{"ottoman", "armchair", Bond::before, 1, 0.1, true},
    Seek{"ottoman", "sofa", Bond::before, 1, 0.1, true},
    Seek{"side table", "sofa", Bond::flank, 2},
    Seek{"side table", "armchair", Bond::flank, 1},
    Seek{"bedside table", "bed", Bond::flank, 2},
    Seek{"bedside table", "sofa", Bond::flank, 2},
};

/// What lies or hangs at the middle of another: rugs under furniture.
struct Under {
  std::string_view other;
  double ahead = 0;  ///< so far in front of the other's centre, in its depths
};
inline constexpr std::array kUnderRugs = {Under{"coffee table"}, Under{"dining table"}, Under{"bed", 0.25},
                                          Under{"sofa", 1}, Under{"desk", 0.5}};

inline constexpr std::array<std::string_view, 7> kKitchenUnits = {"fridge", "kitchen cabinet", "sink",    "dishwasher",
                                                                  "cooker", "counter",         "cupboard"};

}  // namespace inhabit::layout
