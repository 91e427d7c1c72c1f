#pragma once
#include "io/formats/scene_members.h"
#include "scene/study.h"

/// What every object of a study's files may hold.
namespace inhabit::io {

constexpr double kManyAnswers = 1e6;

template <>
struct Table<scene::StudyAnswer> {
  using T = scene::StudyAnswer;
  static constexpr std::tuple members{
      Member{"scene", &T::scene, {"the room", "", 0, 0, true}},
      Member{"synthesis", &T::synthesis, {"what stood beside the human design", "", 0, 0, true}},
      Member{"human", &T::human, {"the side of the human design", "", 0, 0, true, "left|right"}},
      Member{"chosen", &T::chosen, {"the side that was chosen", "", 0, 0, true, "left|right"}},
      Member{"seconds", &T::seconds, {"for which the pair was looked at", "", 0, 1e9}}};
};

template <>
struct Table<scene::StudyParticipant> {
  using T = scene::StudyParticipant;
  static constexpr std::tuple members{Member{"id", &T::id, {"from the seed of the order", "", 0, 0, true}},
                                      Member{"answers", &T::answers, {"in the order given", "", 0, 0, true}}};
};

template <>
struct Table<scene::StudyCount> {
  using T = scene::StudyCount;
  static constexpr std::tuple members{
      Member{"scene", &T::scene, {"the room", "", 0, 0, true}},
      Member{"synthesis", &T::synthesis, {"what stood beside the human design", "", 0, 0, true}},
      Member{"human", &T::human, {"times the human design was chosen", "", 0, kManyAnswers, true}},
      Member{"of", &T::of, {"times the pair was shown", "", 1, kManyAnswers, true}}};
};

template <>
struct Table<scene::StudyData> {
  using T = scene::StudyData;
  static constexpr std::tuple members{Member{"study", &T::study, {"of which page"}},
                                      Member{"participants", &T::participants, {"who answered"}},
                                      Member{"counts", &T::counts, {"instead of participants"}}};
};

template <>
struct Table<scene::StudyScene> {
  using T = scene::StudyScene;
  static constexpr std::tuple members{
      Member{"name", &T::name, {"the room", "", 0, 0, true}},
      Member{"human", &T::human, {"views of the human design: pictures or scenes", "", 0, 0, true}},
      Member{"syntheses", &T::syntheses, {"what is compared with it, by name", "", 0, 0, true}}};
};

template <>
struct Table<scene::StudyPlan> {
  using T = scene::StudyPlan;
  static constexpr std::tuple members{Member{"title", &T::title, {"of the page"}},
                                      Member{"task", &T::task, {"what people are asked; empty lines part paragraphs"}},
                                      Member{"scenes", &T::scenes, {"the rooms", "", 0, 0, true}}};
};

constexpr std::string_view kStudyName = "inhabit-study", kAnswersName = "inhabit-answers";
constexpr int kStudyVersion = 1;

}  // namespace inhabit::io
