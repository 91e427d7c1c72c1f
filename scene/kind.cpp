#include "scene/kind.h"

#include <array>

namespace inhabit::scene {
namespace {

using enum KindTrait;

/// Names come from the catalogues of Sweet Home 3D and the asset types of AI2-THOR.
constexpr std::array kTable = {
    KindRow{"stairs", building, "staircase|stairs|stairway|escalator|stair"},
    KindRow{"railing", building, "railing|rails|fence|pedestrian railing|iron railing"},
    KindRow{"building part", building,
            "beam|slope|roof|roof part|pole|pipe|column|chimney|garage door|garage roof|elevator|sliding "
            "doors|doorframe|door frame"},
    KindRow{"fireplace", building, "fireplace"},
    KindRow{"curtain", wall, "curtain|curtains|blind|blinds|shutter|shower curtain"},
    KindRow{"rug", flat, "rug|carpet|doormat|bathmat|tatami|round carpet|mat|parking slot"},
    KindRow{"pet bed", furniture, "dog bed|dog house|cat bed"},
    KindRow{"bedside table", furniture, "bedside table|nightstand|night stand|night table|bedsidetable"},
    KindRow{"bunk bed", furniture, "bunk bed|mezzanine bed|loft bed|corner bunk bed"},
    KindRow{"bed", furniture, "bed|crib|futon|day bed|captain s bed|air mattress"},
    KindRow{"tv stand", furniture, "tv stand|tv unit|television cabinet|tvstand"},
    KindRow{"tv remote", small, "tv remote|remote control|remote"},
    KindRow{"tv", small, "tv|television|flat tv|flattv"},
    KindRow{"ottoman", furniture, "ottoman|puff|footstool|armchair ottoman|pouf"},
    KindRow{"armchair", furniture, "armchair|arm chair|relax chair"},
    KindRow{"sofa", furniture, "sofa|couch|corner sofa|burlap sofa|loveseat"},
    KindRow{"office chair", furniture, "office chair|desk chair|swivel chair"},
    KindRow{"piano bench", furniture, "piano bench|piano stool"},
    KindRow{"stool", furniture, "stool|bar stool|bar chair"},
    KindRow{"bench", furniture, "bench|bank"},
    KindRow{"chair", furniture, "chair|seat|deck chair|wheelchair"},
    KindRow{"tableware", small, "plate|bowl|cup|mug|fork|knife|spoon|bottle|vase|pot|pan|kettle|butter knife|tray"},
    KindRow{"desk lamp", small, "desk lamp|work lamp|table lamp|little lamp|worklamp|desklamp"},
    KindRow{"floor lamp", furniture, "floor lamp|floor uplight|standing lamp|pedestal vase lamp"},
    KindRow{"wall lamp", wall, "wall uplight|wall light|wall spotlight|wall lamp|sconce"},
    KindRow{"ceiling lamp", ceiling,
            "pendant lamp|ceiling lamp|hanging light|chandelier lamp|chandelier|spotlight|ceiling fan|track "
            "lights|light source"},
    KindRow{"desktop computer", small, "desktop|computer|laptop|screen|keyboard|apple imac|notebook"},
    KindRow{"desk", furniture, "desk|wooden desk|office desk|workbench|desk table"},
    KindRow{"dressing table", furniture, "dressing table|vanity|double vanity"},
    KindRow{"coffee table", furniture, "coffee table|coffeetable|living room table"},
    KindRow{"side table", furniture, "side table|sidetable|end table"},
    KindRow{"dining table", furniture, "dining table|round table|dining room table|glass dining table|diningtable"},
    KindRow{"pool table", furniture, "pool table|table tennis|football table|billiard table"},
    KindRow{"table", furniture, "table|square table|oak table|kitchen table"},
    KindRow{"wardrobe", furniture, "wardrobe|closet|clothes rack|armoire"},
    KindRow{"dresser", furniture, "dresser|chest of drawers|drawers cabinet|drawer"},
    KindRow{"chest freezer", furniture, "chest freezer"},
    KindRow{"chest", furniture, "chest|trunk|trunck"},
    KindRow{"bookcase", furniture, "bookcase|bookshelf|shelving unit|shelvingunit|filled bookcase|vertical shelves"},
    KindRow{"filing cabinet", furniture, "filing cabinet|locker|safe"},
    KindRow{"washbasin", furniture, "washbasin|wash basin|basin|small lavatory|sink cabinet washbasin"},
    KindRow{"upper cabinet", wall,
            "upper cabinet|kitchen upper cabinet|small upper cabinet|upper corner cabinet|medicine box"},
    KindRow{"kitchen cabinet", furniture,
            "kitchen cabinet|lower cabinet|high cabinet|sink cabinet|lower corner cabinet"},
    KindRow{"kitchen island", furniture, "countertop island|island|island extension|worktop"},
    KindRow{"counter", furniture, "countertop|counter top|counter|bar"},
    KindRow{"cupboard", furniture, "cupboard|cabinet|sideboard|buffet|glass door cabinet"},
    KindRow{"fridge", furniture, "fridge|refrigerator|freezer"},
    KindRow{"cooker", furniture, "cooker|stove|oven|cooktop|induction cooker"},
    KindRow{"hood", wall, "hood|range hood"},
    KindRow{"dishwasher", furniture, "dishwasher"},
    KindRow{"washing machine", furniture,
            "washing machine|clothes washer|clothes washing machine|dryer machine|clothes dryer|washingmachine"},
    KindRow{"sink", furniture, "sink"},
    KindRow{"bidet", furniture, "bidet|urinal"},
    KindRow{"toilet paper", wall, "toilet paper|toilet paper hanger|toilet paper dispenser|paper towel holder"},
    KindRow{"toilet", furniture, "toilet|toilet unit|toilets unit"},
    KindRow{"bath", furniture, "bath|bathtub|fitted bath|corner bathtub|jacuzzi"},
    KindRow{"shower", furniture, "shower|shower stall|shower head"},
    KindRow{"radiator", wall, "radiator|electric radiator|hot water radiator|towel rack|towel holder"},
    KindRow{"mirror", wall, "mirror"},
    KindRow{"picture", wall, "painting|photo|frame|picture|wall decor|white board|calendar|poster"},
    KindRow{"shelf", wall, "shelf|shelves|wall hanger|cuckoo clock|light switch|clock"},
    KindRow{"piano", furniture, "piano|grand piano|upright piano"},
    KindRow{"coat rack", furniture, "coat rack|clothes hanger|coat stand"},
    KindRow{"flowers", small, "flowers|tulips|orchids|flower"},
    KindRow{"plant", furniture, "plant|houseplant|house plant|ficus|bamboo|yucca|cactus|palm tree|tree|bonsai"},
    KindRow{"trash can", furniture, "dustbin|trash|trash can|bin|garbage can|garbage bag|recycling bin|trashcan"},
    KindRow{"aquarium", furniture, "aquarium"},
    KindRow{"person", furniture, "male|female|boy|girl|mannequin"},
    KindRow{"microwave", small, "microwave|toaster|coffee machine|coffee maker|blender|mixer"},
    KindRow{"candle", small, "candle|statue|tabletop decor|table top decor|teddy bear|doll|figurine"},
    KindRow{"small thing", small,
            "book|pillow|pen|pencil|egg|keychain|credit card|cellphone|watch|newspaper|alarm clock|soap|spray "
            "bottle|tissue box|apple"
            "|bread|potato|tomato|lettuce|cd|sponge|towel|hand towel|phone|shaker|spatula|ladle|cloth|radio|speaker"},
};

constexpr bool lower(char c) { return c >= 'a' && c <= 'z'; }
constexpr bool upper(char c) { return c >= 'A' && c <= 'Z'; }

/// True when `phrase` stands in `words` between spaces; `words` begins and ends with one.
bool has_phrase(std::string_view words, std::string_view phrase) {
  for (std::size_t at = words.find(phrase); at != std::string_view::npos; at = words.find(phrase, at + 1)) {
    if (words[at - 1] == ' ' && words[at + phrase.size()] == ' ') return true;
  }
  return false;
}

}  // namespace

std::span<const KindRow> kind_table() { return kTable; }

const KindRow* find_kind(std::string_view kind) {
  for (const KindRow& row : kTable) {
    if (row.kind == kind) return &row;
  }
  return nullptr;
}

std::string words_of(std::string_view name, char separator) {
  std::string out;
  bool gap = false;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const char c = name[i];
    const bool beyond_ascii = static_cast<unsigned char>(c) >= 0x80;
    if (!lower(c) && !upper(c) && !beyond_ascii) {
      gap = true;
      continue;
    }
    // A new word at "aB", and before the last capital of "TVStand".
    const bool next_lower = i + 1 < name.size() && lower(name[i + 1]);
    if (upper(c) && i > 0 && (lower(name[i - 1]) || (upper(name[i - 1]) && next_lower))) gap = true;
    if (gap && !out.empty()) out += separator;
    gap = false;
    out += upper(c) ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return out;
}

std::string_view kind_of(std::string_view name) {
  const std::size_t maker = name.find('#');
  if (maker != std::string_view::npos) name.remove_prefix(maker + 1);
  std::string words = words_of(name, ' ');
  // The vendor of some assets is written like a word of the name.
  constexpr std::string_view kVendor = "robo thor ";
  if (words.starts_with(kVendor)) words.erase(0, kVendor.size());
  if (words.empty()) return "";
  if (const KindRow* exact = find_kind(words)) return exact->kind;
  if (words == "top") return "kitchen island";  // of several units
  words = " " + words + " ";
  for (const KindRow& row : kTable) {
    std::string_view rest = row.phrases;
    while (!rest.empty()) {
      const std::size_t bar = rest.find('|');
      if (has_phrase(words, rest.substr(0, bar))) return row.kind;
      rest = bar == std::string_view::npos ? std::string_view() : rest.substr(bar + 1);
    }
  }
  return "";
}

std::string_view kind_of(std::string_view name, std::string_view catalog_id, double height) {
  std::string_view kind = kind_of(name);
  if (kind.empty()) kind = kind_of(catalog_id);
  return kind == "table" && height <= 0.55 ? "coffee table" : kind;
}

}  // namespace inhabit::scene
