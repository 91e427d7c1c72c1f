#pragma once
#include <string>
#include <vector>

/// A study in which people choose between two pictures of a room, and what they chose.
namespace inhabit::scene {

/// One side of a pair: views of one arrangement, as pictures or scenes.
struct StudyPlate {
  std::string name;
  std::vector<std::string> pictures;  ///< files, or names of built-in scenes
  friend bool operator==(const StudyPlate&, const StudyPlate&) = default;
};

/// A room: what a person designed, and what is compared with it.
struct StudyScene {
  std::string name;
  std::vector<std::string> human;
  std::vector<StudyPlate> syntheses;
  friend bool operator==(const StudyScene&, const StudyScene&) = default;
};

struct StudyPlan {
  std::string title, task;
  std::vector<StudyScene> scenes;
  friend bool operator==(const StudyPlan&, const StudyPlan&) = default;
};

enum class Side { left, right };

struct StudyAnswer {
  std::string scene, synthesis;
  Side human = Side::left;   ///< where the human design was shown
  Side chosen = Side::left;  ///< what was clicked
  double seconds = 0;        ///< for which the pair was looked at
  bool chose_human() const { return human == chosen; }
  friend bool operator==(const StudyAnswer&, const StudyAnswer&) = default;
};

struct StudyParticipant {
  std::string id;
  std::vector<StudyAnswer> answers;
  friend bool operator==(const StudyParticipant&, const StudyParticipant&) = default;
};

/// How often the human design was chosen.
struct StudyCount {
  std::string scene, synthesis;
  int human = 0, of = 0;
  friend bool operator==(const StudyCount&, const StudyCount&) = default;
};

/// What a study gave: answers of people, or only counts.
struct StudyData {
  std::string study;  ///< which page the answers come from; empty for counts
  std::vector<StudyParticipant> participants;
  std::vector<StudyCount> counts;
  friend bool operator==(const StudyData&, const StudyData&) = default;
};

}  // namespace inhabit::scene
