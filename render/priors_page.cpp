#include "render/priors_page.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/text.h"
#include "render/frame.h"
#include "render/priors_charts.h"

namespace inhabit::render {
namespace {

using namespace scene;

constexpr double kText = 10.5, kGap = 14;

Drawing blank_card(const std::string& title, const std::string& subtitle) {
  Drawing card{kPriorCard, rgb(0xffffff), title, {}};
  const std::array frame = {Vec2{0.5, 0.5}, Vec2{kPriorCard.x - 0.5, 0.5}, Vec2{kPriorCard.x - 0.5, kPriorCard.y - 0.5},
                            Vec2{0.5, kPriorCard.y - 0.5}};
  stroke(card, Path{}.polygon(frame), ink::kHairline, 1);
  write(card, {fitted(title, kPriorCard.x - 32, 14, true), {16, 24}, 14, ink::kText, Anchor::start, true});
  write(card, {fitted(subtitle, kPriorCard.x - 32, kText), {16, 41}, kText, ink::kFaint});
  return card;
}

std::string counted(int n, std::string_view one, std::string_view many) {
  return std::to_string(n) + " " + std::string(n == 1 ? one : many);
}

std::string degrees_text(double angle) { return shortest(std::round(degrees(angle)) + 0.0) + "°"; }

std::string support_text(const KindPrior& prior) {
  std::string text;
  for (const Support& s : prior.support) {
    static constexpr std::array<std::string_view, 3> kMounts = {"on the floor", "on a wall", "from the ceiling"};
    text += text.empty() ? "" : ", ";
    text += s.on.empty() ? std::string(kMounts[static_cast<std::size_t>(s.mount)]) : "on a " + s.on;
    if (prior.support.size() > 1) text += " (" + std::to_string(s.count) + ")";
  }
  return text;
}

std::string access_text(const KindPrior& prior) {
  std::string text;
  for (std::size_t f = 0; f < prior.access.size(); ++f)
    if (prior.access[f] > 0)
      text +=
          (text.empty() ? "reached at " : ", ") + std::string(kFaceNames[f]) + " " + fixed(prior.access[f], 2) + " m";
  return text;
}

/// One line of the legend for every mode.
void list_modes(Drawing& card, Vec2 at, const std::vector<std::string>& lines) {
  constexpr std::size_t kMost = 9;
  for (std::size_t i = 0; i < std::min(kMost, lines.size()); ++i) {
    const double y = at.y + 15 * static_cast<double>(i);
    fill(card, Path{}.circle({at.x + 4, y - 3.5}, 3.6), mode_color(static_cast<int>(i)));
    write(card, {fitted(lines[i], kPriorCard.x - 14 - at.x - 12, 9.5), {at.x + 13, y}, 9.5, ink::kText});
  }
}

/// The seconds as they stand round the first, whose front is up.
void draw_round(Drawing& card, Vec2 center, double radius, const PairPrior& prior, const PairEvidence& evidence) {
  double far = 0.5 * std::max(evidence.first_size.x, evidence.first_size.y) + 0.1;
  for (const PairSample& s : evidence.samples) far = std::max(far, s.distance + 0.2);
  for (const PairMode& m : prior.modes) far = std::max(far, m.distance + 0.2);
  const double scale = radius / far;
  const auto page = [&](double bearing, double distance) {
    const Vec2 d = distance * direction(wrap_angle(bearing));
    return center + scale * Vec2{-d.y, -d.x};
  };
  for (double ring = 1; ring <= far; ring += far > 5 ? 2 : 1) {
    stroke(card, Path{}.circle(center, scale * ring), ink::kHairline, 0.7);
    write(card,
          {shortest(ring) + " m", center + Vec2{scale * ring * 0.71 + 2, scale * ring * 0.71 + 8}, 8.5, ink::kFaint});
  }
  const Box first{center, {0, -1}, 0.5 * scale * evidence.first_size.y, 0.5 * scale * evidence.first_size.x};
  add(card, Path{}.polygon(first), {.fill = rgb(0xe9e4da), .stroke = rgb(0x8a8272), .width = 1});
  const double tip = 0.5 * scale * evidence.first_size.y;
  fill(card,
       Path{}
           .move(center + Vec2{0, -tip - 5})
           .line(center + Vec2{4, -tip + 1})
           .line(center + Vec2{-4, -tip + 1})
           .close(),
       rgb(0x8a8272));
  for (const PairSample& s : evidence.samples) {
    const Vec2 p = page(s.bearing, s.distance);
    // Heading = bearing + half a turn (towards the first) + facing.
    const Vec2 d = direction(wrap_angle(s.bearing + kPi + s.facing)), way{-d.y, -d.x};
    Color color = mode_color(s.mode);
    color.alpha = 0.65;
    stroke(card, Path{}.segment(p, p + 9 * way), color, 1.6);
    fill(card, Path{}.circle(p, 3.2), color);
  }
  for (std::size_t m = 0; m < prior.modes.size(); ++m) {
    const Color color = mode_color(static_cast<int>(m));
    if (prior.concentric) {
      add(card, Path{}.circle(center, scale * prior.modes[m].distance),
          {.stroke = color, .width = 1.4, .dash = 4, .gap = 3});
      continue;
    }
    const Vec2 p = page(prior.modes[m].bearing, prior.modes[m].distance);
    add(card, Path{}.circle(p, 6.5), {.stroke = color, .width = 1.8});
  }
}

}  // namespace

Drawing draw_kind_card(const KindPrior& prior, const KindEvidence& evidence) {
  std::string subtitle = counted(prior.count, "example", "examples") + " in " + counted(prior.rooms, "room", "rooms");
  if (prior.count == 1) subtitle += " (weak)";
  if (const std::string support = support_text(prior); !support.empty()) subtitle += " · " + support;
  if (const std::string access = access_text(prior); !access.empty()) subtitle += " · " + access;
  Drawing card = blank_card(prior.kind, subtitle);
  std::vector<Tally> distances, angles;
  for (const WallSample& s : evidence.wall)
    distances.push_back({s.distance, s.mode}), angles.push_back({s.angle, s.mode});
  std::vector<Bell> lengths, turns;
  std::vector<std::string> lines;
  for (const WallMode& m : prior.wall) {
    lengths.push_back({m.distance, m.distance_deviation}), turns.push_back({m.angle, m.angle_deviation});
    lines.push_back(std::to_string(m.count) + ": " + fixed(m.distance, 2) + " m, " + degrees_text(m.angle));
  }
  if (evidence.wall.empty()) return card;
  const std::string face(kFaceNames[static_cast<std::size_t>(prior.back)]);
  draw_histogram(card, {34, 58}, {226, 160}, distances, lengths, face + " face to the nearest wall [m]");
  const Vec2 center{372, 144};
  // The wall that the headings are counted from.
  stroke(card, Path{}.segment(center + Vec2{-60, 92}, center + Vec2{60, 92}), ink::kWall, 5);
  draw_rose(card, center, 78, angles, turns);
  write(card, {"heading over the wall", center + Vec2{0, 114}, 9.5, ink::kFaint, Anchor::middle});
  list_modes(card, {474, 72}, lines);
  return card;
}

Drawing draw_pair_card(const PairPrior& prior, const PairEvidence& evidence) {
  std::string subtitle = counted(prior.count, "example", "examples") + " in " + counted(prior.rooms, "room", "rooms") +
                         ", " + shortest(std::round(100 * prior.per_first) / 100) + " to one, spread " +
                         shortest(std::round(1000 * prior.spread) / 10) + " %";
  if (prior.concentric) subtitle += ", concentric";
  subtitle += prior.by_hand ? ", named by the user" : ", proposed";
  Drawing card = blank_card(prior.second + " to " + prior.first, subtitle);
  draw_round(card, {152, 156}, 100, prior, evidence);
  std::vector<Tally> facings;
  for (const PairSample& s : evidence.samples) facings.push_back({s.facing, s.mode});
  std::vector<Bell> turns;
  std::vector<std::string> lines;
  for (const PairMode& m : prior.modes) {
    turns.push_back({m.facing, m.facing_deviation});
    std::string line = std::to_string(m.count) + ": " + fixed(m.distance, 2) + " m";
    if (!prior.concentric) line += ", " + degrees_text(m.bearing);
    lines.push_back(line + ", facing " + degrees_text(m.facing));
  }
  const Vec2 center{364, 146};
  draw_rose(card, center, 78, facings, turns);
  write(card, {"facing: up looks at the " + prior.first, center + Vec2{0, 104}, 9.5, ink::kFaint, Anchor::middle});
  list_modes(card, {454, 72}, lines);
  return card;
}

Drawing draw_priors(const Priors& priors, std::span<const KindEvidence> kinds, std::span<const PairEvidence> pairs,
                    std::string_view title) {
  std::vector<Drawing> cards;
  for (std::size_t i = 0; i < priors.pairs.size(); ++i) cards.push_back(draw_pair_card(priors.pairs[i], pairs[i]));
  std::vector<std::size_t> order(priors.kinds.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order,
                           [&](std::size_t a, std::size_t b) { return priors.kinds[a].count > priors.kinds[b].count; });
  for (const std::size_t i : order) cards.push_back(draw_kind_card(priors.kinds[i], kinds[i]));
  const std::size_t columns = cards.size() < 4 ? 1 : cards.size() < 25 ? 2 : 3;
  const double head = 52, rows = std::ceil(static_cast<double>(cards.size()) / static_cast<double>(columns));
  const double across = static_cast<double>(columns) * (kPriorCard.x + kGap) + kGap;
  Drawing page{{across, head + rows * (kPriorCard.y + kGap) + kGap}, ink::kPaper, std::string(title), {}};
  write(page, {fitted(title, across - 2 * kGap, 18, true), {kGap, 32}, 18, ink::kText, Anchor::start, true});
  for (std::size_t i = 0; i < cards.size(); ++i) {
    const Vec2 at{kGap + static_cast<double>(i % columns) * (kPriorCard.x + kGap),
                  head + static_cast<double>(i / columns) * (kPriorCard.y + kGap)};
    place(page, cards[i], at, 1);
  }
  return page;
}

}  // namespace inhabit::render
