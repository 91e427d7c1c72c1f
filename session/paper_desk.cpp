#include <array>
#include <string>

#include "session/paper_scenes.h"
#include "session/scene_builder.h"

namespace inhabit::session {
namespace {

/// Six books, the largest below; the lowest one stands for the stack.
std::vector<Ref> add_book_stack(Scene& scene, std::size_t first) {
  std::vector<Ref> books;
  for (std::size_t k = 0; k < 6; ++k) {
    // Whole millimetres, so that the file is readable.
    const double smaller = 8 * static_cast<double>(k), thick = 20 + 5 * static_cast<double>(k % 3);
    books.push_back(add_object(scene, numbered("book", first + k), "book",
                               {(180 - smaller) / 1000, (250 - smaller) / 1000, thick / 1000}));
  }
  for (std::size_t k = 1; k < books.size(); ++k) stack(scene, books[k], books[k - 1]);
  return books;
}

}  // namespace

/// Thesis A.4 on a desk top of 1.6 m by 0.8 m, which is the room: one sits at wall 0, the wall behind is wall 2.
/// The 21 objects are those of 6.2.1.4 (they add up to table 1's 21). A.4 also speaks of a notepad and a Rubik's cube
/// that are not among them: the binder takes the notepad's place (front right), the mug the cube's (front left, with
/// the pencils and a stack of books round it). The distances are those of one desk that satisfies them all.
Scene desk() {
  Scene scene;
  scene.name = "desk";
  scene.space = rectangular_space(1.6, 0.8, 1.2);
  const std::vector<Ref> left_stack = add_book_stack(scene, 1), right_stack = add_book_stack(scene, 7);
  std::array<Ref, 3> pencils;
  for (std::size_t k = 0; k < 3; ++k)
    pencils[k] = add_object(scene, numbered("pencil", k + 1), "pencil", {0.01, 0.18, 0.01});
  const Ref plate = add_object(scene, "plate", "plate", {0.2, 0.2, 0.04});
  const Ref binder = add_object(scene, "binder", "binder", {0.25, 0.31, 0.04});
  const Ref frame = add_object(scene, "photo-frame", "photo frame", {0.18, 0.06, 0.22});
  const Ref plant = add_object(scene, "plant", "plant", {0.15, 0.15, 0.3});
  const Ref laptop = add_object(scene, "laptop", "laptop", {0.34, 0.24, 0.22}, {.front = 0.05});
  const Ref mug = add_object(scene, "mug", "mug", {0.09, 0.12, 0.1});

  centre_at(scene, {laptop}, {0.8, 0.22});
  centre_at(scene, {binder}, {1.35, 0.2});
  centre_at(scene, {mug}, {0.25, 0.2});
  keep_distance(scene, plant, left_stack[0], 0.3);
  keep_distance(scene, right_stack[0], binder, 0.4);
  keep_distance(scene, binder, frame, 0.62);
  keep_distance(scene, frame, mug, 0.66);
  // Pencils 6 cm apart lie side by side, or they would cross: the parallel headings are ours.
  keep_distance(scene, pencils[0], pencils[1], 0.06);
  keep_distance(scene, pencils[1], pencils[2], 0.06);
  run_parallel(scene, {pencils[1], pencils[2]}, pencils[0]);
  gather_round(scene, laptop, {plate}, 0.38);
  gather_round(scene, mug, {pencils[0], pencils[1], pencils[2]}, 0.2);
  gather_round(scene, mug, {left_stack[0]}, 0.45);
  stand_at_wall(scene, {left_stack[0]}, 0.02, 2);
  turn_from_wall(scene, {left_stack[0]}, 0, 2);
  return scene;
}

}  // namespace inhabit::session
