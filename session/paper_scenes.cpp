#include "session/paper_scenes.h"

#include <array>

namespace inhabit::session {
namespace {

using enum TheaterCurve;

/// Published seconds: TVCG table 1, thesis table 6.2; appendix C: "no more than 4 seconds" for a suggestion.
constexpr std::array kScenes = {
    PaperScene{"theater-1", [] { return theater_1(); }, "200 seats in tiers round a stage, two lanes between them", 201,
               39.50, 5852},
    PaperScene{"theater-2-arc-0", [] { return theater_2(arc, 0); }, "Nine curved tiers, no pathway", 181, 1.27, 0},
    PaperScene{"theater-2-arc-1", [] { return theater_2(arc, 1); }, "Nine curved tiers, one pathway", 181, 1.31, 0},
    PaperScene{"theater-2-arc-2", [] { return theater_2(arc, 2); }, "Nine curved tiers, two pathways", 181, 1.36, 0},
    PaperScene{"theater-2-segment-0", [] { return theater_2(segment, 0); }, "Twelve straight rows, no pathway", 169,
               0.48, 0},
    PaperScene{"theater-2-segment-1", [] { return theater_2(segment, 1); }, "Twelve straight rows, one pathway", 169,
               0.52, 0},
    PaperScene{"theater-2-segment-2", [] { return theater_2(segment, 2); }, "Seven wide rows, two pathways", 246, 0.73,
               0},
    PaperScene{"picnic", picnic, "Tables with chairs, grills, trash cans and a carousel on a lawn", 77, 4.77, 253},
    PaperScene{"living-room", living_room, "Sofa and armchairs round a television, and a desk", 10, 0.62, 26.78},
    PaperScene{"desk", desk, "Books, a laptop and small things on a desk top", 21, 0.69, 37.06},
    PaperScene{"tight-bedroom", [] { return tight_bedroom(); }, "Three bunks with lockers, little floor left", 12, 0.67,
               22.31},
    PaperScene{"tight-picnic", [] { return tight_picnic(); }, "Tables with chairs fixed to them, crowded on a lawn", 53,
               2.42, 109.43},
    PaperScene{"hosting-room", hosting_room, "Five dining tables, a clothes rack and a lamp", 0, 4, 0},
    PaperScene{"outdoor-yard", outdoor_yard, "Two patio tables with chairs, a grill kept away from them", 0, 4, 0},
    PaperScene{"game-room", game_room, "Two table tennis tables, two dining sets, a sofa at the wall", 0, 4, 0},
    PaperScene{"bedroom", bedroom, "Bed, closet, rack, a desk with its chair and lamp", 0, 4, 0},
    PaperScene{"living-room-photo", living_room_photo, "A television as focal point, a coffee table, a desk", 0, 4, 0},
};

}  // namespace

std::span<const PaperScene> paper_scenes() { return kScenes; }

const PaperScene* find_paper_scene(std::string_view name) {
  for (const PaperScene& scene : kScenes)
    if (scene.name == name) return &scene;
  return nullptr;
}

}  // namespace inhabit::session
