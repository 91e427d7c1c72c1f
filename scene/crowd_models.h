#pragma once
#include "core/type_list.h"
#include "scene/field.h"

/// The parameters of every model of how people walk: what a scene document says about it. What they mean stands in
/// crowd/models/, one file per model. Paper keys and equation numbers: docs/papers.md.
namespace inhabit::scene {

/// Position-based crowds (thesis ch. 4, algorithm 2).
struct PbdModel {
  /// Values that the other members have when a document does not say them.
  enum class Preset { game, pedestrian };
  Choice preset = 0;
  Choice far = 0;  ///< what is done about collisions to come: FarField
  double relaxation_time = 0.54, contact_margin = 0.02, over_relaxation = 1.8;
  int stability_iterations = 1, iterations = 1, sub_steps = 8, fewest_sub_steps = 8;
  double static_friction = 0.21, kinetic_friction = 0.10;
  double cohesion = 0, cohesion_range = 7;
  double far_stiffness = 0.24, far_horizon = 20, far_range = 5;
  int far_neighbours = 10;
  double maximum_acceleration = 20;
  double headway = 0, headway_length = 0, headway_breadth = 1, anticipation = 0, sidestep = 0, hesitation = 0;
  static constexpr std::string_view kName = "pbd";
  static constexpr std::array kFields = {
      Field<PbdModel>{"preset", &PbdModel::preset, "the values of what is not said: the thesis's or people's", "", 0, 0,
                      false, "game|pedestrian"},
      Field<PbdModel>{"far", &PbdModel::far, "collisions to come: long-range (thesis 4.2.4), avoidance (4.2.5), off",
                      "", 0, 0, false, "off|long-range|avoidance"},
      Field<PbdModel>{"relaxation_time", &PbdModel::relaxation_time,
                      "time xi in which a velocity turns into the preferred one: alpha = dt / xi (eq. 4.1)", "s", 0.01,
                      100},
      Field<PbdModel>{"contact_margin", &PbdModel::contact_margin, "share by which radii grow in contact tests", "", 0,
                      1},
      Field<PbdModel>{"over_relaxation", &PbdModel::over_relaxation, "factor on averaged corrections", "", 0.1, 1.99},
      Field<PbdModel>{"stability_iterations", &PbdModel::stability_iterations,
                      "projections of contacts left from the step before", "", 0, 100},
      Field<PbdModel>{"iterations", &PbdModel::iterations, "projections in a step, of each sub-step", "", 1, 1000},
      Field<PbdModel>{"sub_steps", &PbdModel::sub_steps,
                      "parts of a step, with the same neighbours, while people overlap", "", 1, 64},
      Field<PbdModel>{"fewest_sub_steps", &PbdModel::fewest_sub_steps,
                      "parts of a step while nobody does; never more than sub_steps", "", 1, 64},
      Field<PbdModel>{"static_friction", &PbdModel::static_friction, "mu_s", "", 0, 10},
      Field<PbdModel>{"kinetic_friction", &PbdModel::kinetic_friction, "mu_k", "", 0, 10},
      Field<PbdModel>{"cohesion", &PbdModel::cohesion, "share of the neighbours' mean velocity taken over in a step",
                      "", 0, 1},
      Field<PbdModel>{"cohesion_range", &PbdModel::cohesion_range, "h of the kernel, in radii", "", 1, 50},
      Field<PbdModel>{"far_stiffness", &PbdModel::far_stiffness, "k of collisions to come", "", 0, 1},
      Field<PbdModel>{"far_horizon", &PbdModel::far_horizon, "tau_0: collisions later than this do not count", "s",
                      0.01, 1000},
      Field<PbdModel>{"far_range", &PbdModel::far_range, "who is farther away does not count", "m", 0.1, 1000},
      Field<PbdModel>{"far_neighbours", &PbdModel::far_neighbours, "the nearest so many count", "", 1, 64},
      Field<PbdModel>{"maximum_acceleration", &PbdModel::maximum_acceleration, "a_max", "m/s^2", 0.1, 1e6},
      Field<PbdModel>{"headway", &PbdModel::headway,
                      "time T in which the gap to who stands ahead may be closed: slows people down; 0: off", "s", 0,
                      60},
      Field<PbdModel>{"headway_length", &PbdModel::headway_length,
                      "room that is kept between bodies one behind the other", "m", 0, 10},
      Field<PbdModel>{"headway_breadth", &PbdModel::headway_breadth,
                      "how many times as wide as deep bodies are for the headway", "", 0.1, 10},
      Field<PbdModel>{"anticipation", &PbdModel::anticipation,
                      "share of the leader's speed that the headway takes for granted", "", 0, 0.95},
      Field<PbdModel>{"sidestep", &PbdModel::sidestep, "widest turn out of the way for a longer way ahead; 0: none",
                      "deg", 0, 89},
      Field<PbdModel>{"hesitation", &PbdModel::hesitation,
                      "share of the time in which somebody whom bodies hold up does not push", "", 0, 1}};
  /// The values of a preset; `preset` says its name.
  static PbdModel of_preset(Preset preset);
  friend bool operator==(const PbdModel& a, const PbdModel& b) { return same_fields(a, b); }
};

/// Energies that fall off with the time to collision (Karamouzas et al. 2014).
struct PowerLawModel {
  double strength = 1.5, horizon = 3, relaxation_time = 0.54, range = 10, maximum_acceleration = 20;
  static constexpr std::string_view kName = "power-law";
  static constexpr std::array kFields = {
      Field<PowerLawModel>{"strength", &PowerLawModel::strength, "k of the energy k tau^-2 exp(-tau / tau_0)", "", 0,
                           1000},
      Field<PowerLawModel>{"horizon", &PowerLawModel::horizon, "tau_0", "s", 0.01, 100},
      Field<PowerLawModel>{"relaxation_time", &PowerLawModel::relaxation_time,
                           "time in which a velocity turns into the preferred one", "s", 0.01, 100},
      Field<PowerLawModel>{"range", &PowerLawModel::range, "who is farther away does not count", "m", 0.1, 1000},
      Field<PowerLawModel>{"maximum_acceleration", &PowerLawModel::maximum_acceleration, "longest force per mass",
                           "m/s^2", 0.1, 1e6}};
  friend bool operator==(const PowerLawModel& a, const PowerLawModel& b) { return same_fields(a, b); }
};

/// Social forces of people in panic (Helbing, Farkas and Vicsek 2000).
struct SocialForceModel {
  double relaxation_time = 0.5, repulsion = 2000, repulsion_range = 0.08, body = 120000, friction = 240000;
  double person_mass = 80, range = 3;
  int sub_steps = 20;
  static constexpr std::string_view kName = "social-force";
  static constexpr std::array kFields = {
      Field<SocialForceModel>{"relaxation_time", &SocialForceModel::relaxation_time, "tau (eq. 1)", "s", 0.01, 100},
      Field<SocialForceModel>{"repulsion", &SocialForceModel::repulsion, "A (eq. 2)", "N", 0, 1e6},
      Field<SocialForceModel>{"repulsion_range", &SocialForceModel::repulsion_range, "B (eq. 2)", "m", 0.001, 10},
      Field<SocialForceModel>{"body", &SocialForceModel::body, "k (eq. 2)", "kg/s^2", 0, 1e7},
      Field<SocialForceModel>{"friction", &SocialForceModel::friction, "kappa (eq. 2)", "kg/(m s)", 0, 1e7},
      Field<SocialForceModel>{"person_mass", &SocialForceModel::person_mass, "kilograms of a person of mass 1", "kg", 1,
                              1e4},
      Field<SocialForceModel>{"range", &SocialForceModel::range, "gaps wider than this do not count", "m", 0.1, 1000},
      Field<SocialForceModel>{"sub_steps", &SocialForceModel::sub_steps, "parts of a step: the body force is stiff", "",
                              1, 1000}};
  friend bool operator==(const SocialForceModel& a, const SocialForceModel& b) { return same_fields(a, b); }
};

/// Optimal reciprocal collision avoidance (van den Berg, Guy, Lin and Manocha 2011).
struct OrcaModel {
  double horizon = 5, wall_horizon = 2, range = 10;
  int neighbours = 10;
  static constexpr std::string_view kName = "orca";
  static constexpr std::array kFields = {
      Field<OrcaModel>{"horizon", &OrcaModel::horizon, "tau: free of collisions for so long", "s", 0.01, 1000},
      Field<OrcaModel>{"wall_horizon", &OrcaModel::wall_horizon, "the same, for walls", "s", 0.01, 1000},
      Field<OrcaModel>{"range", &OrcaModel::range, "who is farther away does not count", "m", 0.1, 1000},
      Field<OrcaModel>{"neighbours", &OrcaModel::neighbours, "the nearest so many count", "", 1, 64}};
  friend bool operator==(const OrcaModel& a, const OrcaModel& b) { return same_fields(a, b); }
};

/// Every model there is. Their names are the document's `type` and the command line's --model.
using CrowdModels = TypeList<PbdModel, PowerLawModel, SocialForceModel, OrcaModel>;
using CrowdModel = std::variant<PbdModel, PowerLawModel, SocialForceModel, OrcaModel>;

}  // namespace inhabit::scene
