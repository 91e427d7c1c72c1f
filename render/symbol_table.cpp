#include <algorithm>

#include "render/symbols.h"

namespace inhabit::render {
namespace {

// Families share a colour: body, light parts, lines.
constexpr Tone kSleep{rgb(0xd5deee), rgb(0xf2f5fa), rgb(0x5d6c8b)};
constexpr Tone kSeat{rgb(0xbfd6cc), rgb(0xe1ede7), rgb(0x50705f)};
constexpr Tone kTable{rgb(0xf0dfc6), rgb(0xf8efe1), rgb(0x8b6d45)};
constexpr Tone kStorage{rgb(0xe3d6c8), rgb(0xf1eae2), rgb(0x7b6753)};
constexpr Tone kWater{rgb(0xdbe8ef), rgb(0xeff6f9), rgb(0x537486)};
constexpr Tone kKitchen{rgb(0xdfe2e5), rgb(0xf1f2f4), rgb(0x5d6770)};
constexpr Tone kScreen{rgb(0xc9ced6), rgb(0xe4e7eb), rgb(0x454c56)};
constexpr Tone kPlant{rgb(0xcbe2bd), rgb(0xe6d7c3), rgb(0x4f7443)};
constexpr Tone kLight{rgb(0xfbeec2), rgb(0xfffaea), rgb(0x937c30)};
constexpr Tone kTextile{rgb(0xf1e2de), rgb(0xf9f1ee), rgb(0xb89a92)};
constexpr Tone kOutdoor{rgb(0xe7c9b4), rgb(0xf7e9de), rgb(0x855a3e)};
constexpr Tone kBin{rgb(0xd6dacb), rgb(0xebede4), rgb(0x666d52)};
constexpr Tone kPaper{rgb(0xe6d3df), rgb(0xf6eef3), rgb(0x7c5d73)};
constexpr Tone kOther{rgb(0xe9e9e6), rgb(0xf6f6f4), rgb(0x696a6b)};

/// Every kind with a symbol of its own. This line is the only registration of a kind; no order is needed.
constexpr SymbolRow kRows[] = {
    {"bed", symbols::bed, kSleep},
    {"crib", symbols::cot, kSleep},
    {"cot", symbols::cot, kSleep},
    {"sofa", symbols::sofa, kSeat},
    {"couch", symbols::sofa, kSeat},
    {"loveseat", symbols::sofa, kSeat},
    {"armchair", symbols::sofa, kSeat},
    {"chair", symbols::chair, kSeat},
    {"office chair", symbols::office_chair, kSeat},
    {"desk chair", symbols::office_chair, kSeat},
    {"deck chair", symbols::sofa, kSeat},
    {"stool", symbols::stool, kSeat, true},
    {"ottoman", symbols::plain, kSeat},
    {"pouf", symbols::stool, kSeat, true},
    {"bench", symbols::bench, kSeat, false, true},
    {"seat", symbols::seat, kSeat},
    {"table", symbols::table, kTable},
    {"picnic table", symbols::table, kTable},
    {"round table", symbols::round_table, kTable, true},
    {"desk", symbols::desk, kTable},
    {"counter", symbols::drawers, kTable, false, true},
    {"nightstand", symbols::drawers, kStorage, false, true},
    {"night stand", symbols::drawers, kStorage, false, true},
    {"footlocker", symbols::drawers, kStorage, false, true},
    {"locker", symbols::wardrobe, kStorage},
    {"clothes rack", symbols::wardrobe, kStorage},
    {"television bench", symbols::drawers, kStorage, false, true},
    {"tv bench", symbols::drawers, kStorage, false, true},
    {"table tennis", symbols::table, kTable},
    {"bedside table", symbols::drawers, kStorage, false, true},
    {"wardrobe", symbols::wardrobe, kStorage},
    {"closet", symbols::wardrobe, kStorage},
    {"cupboard", symbols::drawers, kStorage, false, true},
    {"cabinet", symbols::drawers, kStorage, false, true},
    {"sideboard", symbols::drawers, kStorage, false, true},
    {"dresser", symbols::drawers, kStorage, false, true},
    {"drawers", symbols::drawers, kStorage, false, true},
    {"chest", symbols::drawers, kStorage, false, true},
    {"tv stand", symbols::drawers, kStorage, false, true},
    {"bookcase", symbols::shelf, kStorage},
    {"bookshelf", symbols::shelf, kStorage},
    {"shelf", symbols::shelf, kStorage},
    {"shelves", symbols::shelf, kStorage},
    {"coat rack", symbols::coat_rack, kStorage, true},
    {"hat stand", symbols::coat_rack, kStorage, true},
    {"television", symbols::screen, kScreen},
    {"tv", symbols::screen, kScreen},
    {"tv set", symbols::screen, kScreen},
    {"monitor", symbols::screen, kScreen},
    {"screen", symbols::screen, kScreen},
    {"computer", symbols::laptop, kScreen},
    {"laptop", symbols::laptop, kScreen},
    {"keyboard", symbols::keyboard, kScreen},
    {"mouse", symbols::stool, kScreen, true},
    {"plant", symbols::plant, kPlant, true},
    {"potted plant", symbols::plant, kPlant, true},
    {"houseplant", symbols::plant, kPlant, true},
    {"flower", symbols::plant, kPlant, true},
    {"tree", symbols::plant, kPlant, true},
    {"bush", symbols::plant, kPlant, true},
    {"lamp", symbols::lamp, kLight, true},
    {"light", symbols::lamp, kLight, true},
    {"rug", symbols::rug, kTextile, false, false, true},
    {"carpet", symbols::rug, kTextile, false, false, true},
    {"mat", symbols::rug, kTextile, false, false, true},
    {"toilet", symbols::toilet, kWater},
    {"sink", symbols::basin, kWater},
    {"washbasin", symbols::basin, kWater},
    {"basin", symbols::basin, kWater},
    {"bathtub", symbols::bathtub, kWater},
    {"bath", symbols::bathtub, kWater},
    {"shower", symbols::shower, kWater},
    {"stove", symbols::stove, kKitchen},
    {"cooker", symbols::stove, kKitchen},
    {"oven", symbols::stove, kKitchen},
    {"hob", symbols::stove, kKitchen},
    {"fridge", symbols::fridge, kKitchen},
    {"refrigerator", symbols::fridge, kKitchen},
    {"freezer", symbols::fridge, kKitchen},
    {"dishwasher", symbols::washer, kKitchen, false, true},
    {"washing machine", symbols::washer, kKitchen, false, true},
    {"washer", symbols::washer, kKitchen, false, true},
    {"dryer", symbols::washer, kKitchen, false, true},
    {"grill", symbols::grill, kOutdoor},
    {"barbecue", symbols::grill, kOutdoor},
    {"carousel", symbols::carousel, kOutdoor, true},
    {"parasol", symbols::parasol, kOutdoor, true},
    {"umbrella", symbols::parasol, kOutdoor, true},
    {"trash can", symbols::bin, kBin, true},
    {"trashcan", symbols::bin, kBin, true},
    {"garbage can", symbols::bin, kBin, true},
    {"bin", symbols::bin, kBin, true},
    {"stage", symbols::stage, kTable, false, false, true},
    {"piano", symbols::piano, kStorage},
    {"pool table", symbols::pool_table, kStorage},
    {"billiard table", symbols::pool_table, kStorage},
    {"book", symbols::book, kPaper},
    {"binder", symbols::book, kPaper},
    {"notebook", symbols::paper, kPaper},
    {"notepad", symbols::paper, kPaper},
    {"paper", symbols::paper, kPaper},
    {"pencil", symbols::pencil, kLight},
    {"pen", symbols::pencil, kScreen},
    {"plate", symbols::plate, kKitchen, true},
    {"bowl", symbols::plate, kKitchen, true},
    {"mug", symbols::mug, kKitchen, true},
    {"cup", symbols::mug, kKitchen, true},
    {"picture", symbols::frame, kPaper},
    {"painting", symbols::frame, kPaper},
    {"photo frame", symbols::frame, kPaper},
    {"picture frame", symbols::frame, kPaper},
    {"mirror", symbols::frame, kWater},
    {"door", symbols::leaf, kOther},
    {"cube", symbols::plain, kPaper},
};
constexpr SymbolRow kUnknown{"", symbols::box, kOther, false, true};

/// Lower case, words parted by one space: `Office-Chair_2` becomes "office chair 2".
std::string words(std::string_view kind) {
  std::string out;
  bool lower_before = false;
  for (const char c : kind) {
    const bool upper = c >= 'A' && c <= 'Z', letter = upper || (c >= 'a' && c <= 'z') || (c & 0x80);
    const bool digit = c >= '0' && c <= '9';
    if (!letter && !digit) {
      if (!out.empty() && out.back() != ' ') out += ' ';
    } else {
      if (upper && lower_before && out.back() != ' ') out += ' ';
      out += upper ? static_cast<char>(c - 'A' + 'a') : c;
    }
    lower_before = letter && !upper;
  }
  return out;
}

}  // namespace

const SymbolRow& symbol_row(std::string_view kind) {
  const std::string text = words(kind);
  const SymbolRow* best = &kUnknown;
  std::size_t best_end = 0;
  for (const SymbolRow& row : kRows) {
    for (std::size_t at = text.find(row.kind); at != std::string::npos; at = text.find(row.kind, at + 1)) {
      std::size_t end = at + row.kind.size();
      if (end < text.size() && text[end] == 's') ++end;
      const bool whole = (at == 0 || text[at - 1] == ' ') && (end == text.size() || text[end] == ' ');
      if (!whole || end < best_end || (end == best_end && row.kind.size() <= best->kind.size())) continue;
      best = &row, best_end = end;
    }
  }
  return *best;
}

}  // namespace inhabit::render
