#pragma once
#include <string>
#include <string_view>

/// For tests only: a document that uses every part of a scene, and random scenes.
namespace inhabit::io {

inline constexpr std::string_view kFullScene = R"({
  "format": "inhabit-scene", "version": 1, "name": "tight bedroom",
  "space": {
    "outline": [[0, 0], [4.6, 0], [4.6, 3.4], [0, 3.4]],
    "holes": [{"id": "pillar", "outline": [[2, 1], [2.3, 1], [2.3, 1.3], [2, 1.3]], "x-material": "stone"}],
    "height": 2.5,
    "doors": [{"id": "door", "wall": 0, "from": 0.4, "width": 0.8, "height": 2, "swing": "out", "hinge": "end", "x-a": 1},
              {"id": "door-2", "wall": 1, "from": 0.4}],
    "windows": [{"id": "window", "wall": 2, "from": 1.0, "width": 1.4, "sill": 0.8, "height": 1.3, "x-pane": {"b": [1, 2]}}],
    "x-floor": "oak"
  },
  "objects": [
    {"id": "bed-1", "kind": "bed", "name": "Küche \"east\"", "size": [0.9, 2.0, 0.5], "position": [1.0, 1.2, 0], "angle": 90,
     "fixed": true, "clearance": {"front": 0.1, "left": 0.5, "right": 0.5}, "view": {"distance": 2.5, "angle": 60.123456789},
     "mount": "wall", "on": null, "mass": 0.9, "model": "bed.glb", "lock": "both", "x-price": 1.50e2},
    {"id": "table"}, {"id": "chair-1"}, {"id": "chair-2"}, {"id": "seat-41"}, {"id": "lamp", "on": "table", "mount": "ceiling"}
  ],
  "groups": [
    {"id": "dining", "members": ["table", "chair-1"], "rigid": true, "position": [1, 1], "angle": -45, "x-color": "red"},
    {"id": "tier", "members": ["seat-41", "chair-2"], "spacing": 0.6,
     "curve": {"arc": {"start": [2, 6], "end": [10, 6], "center": [6, 1]}}},
    {"id": "all", "members": ["tier", "dining"], "curve": {"segment": {}}},
    {"id": "rest", "members": ["lamp"], "curve": {"segment": {"start": [0, 0], "end": [1, 1]}}}
  ],
  "constraints": [
    {"type": "distance", "between": ["lamp", "chair-1"], "distance": 0.8, "stiffness": 0.8, "weight": 1, "x-why": "light"},
    {"type": "focal_distance", "focal": "table", "members": "tier", "min": 0.5, "max": 1, "focal_fixed": true},
    {"type": "traffic_lane", "from": "bed-1", "angle": 30, "clearance": 0.5, "members": ["tier"], "from_fixed": false},
    {"type": "heat_point", "members": ["tier"], "point": [1, 2], "on": "table"},
    {"type": "focal_symmetry", "focal": "bed-1", "members": "dining", "focal_fixed": false},
    {"type": "visual_balance"},
    {"type": "align", "members": ["table", "chair-1"], "axis": 12.5},
    {"type": "region", "members": ["table"], "polygon": [[0, 0], [1, 0], [0, 1]]},
    {"type": "keep_out", "polygon": [[0, 0], [1, 0], [0, 1]]},
    {"type": "pathway", "between": ["door", "door-2"], "width": 1},
    {"type": "visibility", "members": ["bed-1"]},
    {"type": "accessibility", "object": "bed-1", "face": "left", "depth": 0.7, "members": ["lamp"]},
    {"type": "stacking", "object": "lamp", "on": "table", "anywhere": true},
    {"type": "wall_distance", "members": ["bed-1"], "distance": 0.1, "wall": 2},
    {"type": "wall_orientation", "members": ["bed-1"], "angle": 180},
    {"type": "orientation", "members": ["chair-1"], "to": "table", "angle": 10, "relative": "parallel"},
    {"type": "collision", "members": ["chair-1", "table"], "mode": "off"}
  ],
  "house_rules": true,
  "crowd": {
    "populations": [{"id": "west", "count": 800, "area": [[0, 0], [20, 0], [20, 40], [0, 40]], "spacing": 2.5,
                     "jitter": 0.25, "walking": true, "radius": [0.5, 0.75], "mass": 2,
                     "speed": {"mean": 1.4, "deviation": 0.1, "maximum": 2}, "goal": "east", "x-c": null},
                    {"area": [[0, 0], [1, 0], [0, 1]], "count": 3, "goal": ["shop", ["east", "shop"], "away"]}],
    "sources": [{"id": "entrance", "area": [[0, 0], [1, 0], [1, 2], [0, 2]], "rate": 2.0, "arrivals": "poisson",
                 "from": 5, "until": 65, "count": 100, "radius": 0.2, "goal": "east", "x-d": [true]}],
    "goals": [{"id": "east", "area": [[80, 0], [82, 0], [82, 40], [80, 40]], "x-e": "f"},
              {"id": "shop", "area": [[8, 0], [9, 0], [8, 4]], "aim": [[8, 0], [8.5, 0], [8, 1]], "wait": 30},
              {"id": "north", "direction": 90}, {"id": "away", "offset": [30, -2], "jitter": 1.5, "absorb": false}],
    "model": {"type": "pbd", "preset": "game", "far": "avoidance", "iterations": 12},
    "planner": "paths", "step": 0.05, "seconds": 90,
    "x-model": "pbd"
  },
  "seed": 18446744073709551615,
  "x-author": {"name": "someone", "deep": [[[1e-7, 12345678901234567890123]]]}
})";

}  // namespace inhabit::io
