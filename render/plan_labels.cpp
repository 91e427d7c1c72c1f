#include <algorithm>
#include <map>
#include <set>

#include "render/plan_parts.h"

/// What is written on a plan, and where.
namespace inhabit::render {
namespace {

constexpr double kSize = 11.5, kLine = 1.22;  // text size, points; line height as a factor

/// "potted_plant" reads as "potted plant".
std::string label_text(const Item& item, bool ids) {
  const scene::Object& o = *item.object;
  std::string text = printable(ids || (o.name.empty() && o.kind.empty()) ? o.id : (o.name.empty() ? o.kind : o.name));
  if (!ids && o.name.empty()) std::ranges::replace(text, '_', ' '), std::ranges::replace(text, '-', ' ');
  return text;
}

/// A text in the ways it may be broken: one line, two lines.
struct Wording {
  std::vector<std::vector<std::string>> breaks;
  std::vector<Vec2> shapes;

  void add(std::vector<std::string> lines, double size, bool bold) {
    double width = 0;
    for (const std::string& line : lines) width = std::max(width, text_width(line, size, bold));
    shapes.push_back({width + 0.35 * size, static_cast<double>(lines.size()) * kLine * size});
    breaks.push_back(std::move(lines));
  }
};

Wording wording(const std::string& text, double size, bool bold) {
  Wording w;
  const std::string whole = fitted(text, 15 * size, size, bold);
  w.add({whole}, size, bold);
  // The blank nearest to the middle.
  std::size_t best = std::string::npos;
  const auto off = [&](std::size_t at) { return std::max(at, whole.size() - at); };
  for (std::size_t at = whole.find(' '); at != std::string::npos; at = whole.find(' ', at + 1))
    if (best == std::string::npos || off(at) < off(best)) best = at;
  if (best != std::string::npos && best > 0 && best + 1 < whole.size())
    w.add({whole.substr(0, best), whole.substr(best + 1)}, size, bold);
  return w;
}

void write_spot(Drawing& drawing, const LabelSpot& spot, const Wording& words, double size, Color color, bool bold) {
  if (!spot.inside) {
    stroke(drawing, Path{}.segment(spot.leader_from, spot.leader_to), color, 0.6);
    fill(drawing, Path{}.circle(spot.leader_to, 1.4), color);
  } else {
    fill(drawing, Path{}.polygon(spot.box), rgb(0xffffff, 0.7));
  }
  const auto& lines = words.breaks[spot.shape];
  const double s = size * spot.scale;
  const Vec2 down = perp(spot.box.front);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const double offset =
        (static_cast<double>(i) - 0.5 * (static_cast<double>(lines.size()) - 1)) * kLine * s + 0.36 * s;
    write(drawing,
          {lines[i], spot.box.center + offset * down, s, color, Anchor::middle, bold, angle_of(spot.box.front)});
  }
}

/// What labels must stay off: objects, walls, pillars, the doors' leaves.
LabelField make_field(const Page& page, const Stock& stock, const scene::Scene& scene) {
  LabelField field{page.area, {}, {}};
  for (const Item& item : stock.items) {
    const Vec3 size = item.object->size;
    // A table top or a rug carries labels of what stands on it; so does whatever is much larger than its things.
    field.obstacles.push_back(
        {page.frame.page(item.box), item.symbol->ground || size.z < 0.02 || item.object->kind == "desk"});
  }
  const scene::Space& space = scene.space;
  for (std::size_t k = 0; k < space.walls(); ++k) {
    const Vec2 a = space.wall_start(k), b = space.wall_end(k), d = unit(b - a);
    const Box wall{0.5 * (a + b) - (stock.wall / 2) * perp(d), d, length(b - a) / 2 + stock.wall, stock.wall / 2};
    field.obstacles.push_back({page.frame.page(wall)});
  }
  for (const scene::Hole& hole : space.holes) {
    const Bounds b = bounds(hole.outline);
    const Vec2 half = 0.5 * b.size();
    if (!hole.outline.empty()) field.obstacles.push_back({page.frame.page(Box{b.center(), {1, 0}, half.x, half.y})});
  }
  for (const scene::Door& door : space.doors) {
    const auto place = door_place(space, door);
    if (!place || door.swing == scene::Door::Swing::none) continue;
    const double h = door.width / 2;
    const Vec2 middle = 0.5 * (place->hinge + place->jamb) + h * place->opening;
    field.obstacles.push_back({page.frame.page(Box{middle, place->opening, h, h})});
  }
  return field;
}

/// Walls are rings of obstacles with nothing known about what lies behind them; dimension lines are obstacles, too.
void add_dimensions(LabelField& field, const Page& page, const Stock& stock) {
  const Vec2 a = page.frame.page(Vec2{stock.room.min.x, stock.room.min.y}), b = page.frame.page(stock.room.max);
  const Vec2 at = measures_corner(page, stock);
  field.obstacles.push_back({{{0.5 * (a.x + b.x), at.y}, {1, 0}, 0.5 * (b.x - a.x), 14 * page.text}});
  field.obstacles.push_back({{{at.x, 0.5 * (a.y + b.y)}, {1, 0}, 14 * page.text, 0.5 * (a.y - b.y)}});
  if (stock.row)
    field.obstacles.push_back(
        {{page.frame.page(*stock.row) + Vec2{75, -4} * page.text, {1, 0}, 80 * page.text, 8 * page.text}});
}

/// Who is labelled, and the kinds that are counted instead: (text, sample, count).
struct Split {
  std::vector<std::size_t> labelled;
  std::vector<LegendRow> counted;
};

Split split(const Stock& stock, const PlanOptions& options) {
  constexpr std::size_t kRows = 24;
  Split out;
  if (stock.items.size() <= options.many) {
    for (std::size_t i = 0; i < stock.items.size(); ++i) out.labelled.push_back(i);
    return out;
  }
  // By kind: one by one they would only hide the plan. Names are kept for what is there at most twice.
  std::map<std::string, std::vector<std::size_t>> kinds;
  for (std::size_t i = 0; i < stock.items.size(); ++i) {
    const scene::Object& o = *stock.items[i].object;
    kinds[o.kind.empty() ? "object" : o.kind].push_back(i);
  }
  std::vector<std::pair<std::size_t, std::string>> order;
  for (const auto& [kind, who] : kinds) order.emplace_back(who.size(), kind);
  std::ranges::stable_sort(order, [](const auto& a, const auto& b) { return a.first > b.first; });
  for (const auto& [count, kind] : order) {
    const auto& who = kinds[kind];
    if (count <= 2 && out.labelled.size() < 40) {
      out.labelled.insert(out.labelled.end(), who.begin(), who.end());
    } else if (out.counted.size() < kRows) {
      std::string text = printable(kind);
      std::ranges::replace(text, '_', ' ');
      std::ranges::replace(text, '-', ' ');
      out.counted.push_back({"", text + " × " + std::to_string(count), &stock.items[who.front()]});
    }
  }
  return out;
}

/// One label for a stack: an item under another one with the same text is counted in the upper one's.
std::vector<std::size_t> count_stacks(const Stock& stock, std::vector<std::size_t>& labelled,
                                      const PlanOptions& options) {
  std::vector<std::size_t> kept, counts;
  for (std::size_t k = labelled.size(); k-- > 0;) {
    const Item& low = stock.items[labelled[k]];
    std::size_t above = kept.size();
    for (std::size_t j = 0; j < kept.size() && above == kept.size(); ++j) {
      const Item& high = stock.items[kept[j]];
      const bool same = low.placed && high.placed && !options.ids && label_text(low, false) == label_text(high, false);
      const Vec2 d = low.box.center - high.box.center;
      const double near = 0.5 * std::min(high.box.half_depth, high.box.half_width);
      if (same && high.base > low.base && dot(d, d) <= near * near) above = j;
    }
    if (above < kept.size()) {
      ++counts[above];
    } else {
      kept.push_back(labelled[k]);
      counts.push_back(1);
    }
  }
  std::ranges::reverse(kept);
  std::ranges::reverse(counts);
  labelled = kept;
  return counts;
}

/// Numbers for the labels that found no room; the same text has the same number.
struct Keys {
  std::map<std::string, std::string> numbers;
  std::vector<std::pair<std::string, std::size_t>> texts;  // in order of their numbers, how often

  std::string number(const std::string& text) {
    const auto [it, fresh] = numbers.try_emplace(text, std::to_string(numbers.size() + 1));
    if (fresh) texts.emplace_back(text, 0);
    ++texts[static_cast<std::size_t>(std::stoul(it->second)) - 1].second;
    return it->second;
  }
};

void write_notes(Drawing& drawing, const Page& page, const std::vector<Note>& notes, LabelField& field) {
  const double size = 10 * page.text;
  std::vector<LabelRequest> requests;
  std::vector<Wording> words;
  LabelField open{field.page, {}, {}};  // a warning may lie over furniture, only not over another
  for (const Note& note : notes) {
    words.push_back(wording(note.text, size, true));
    words.back().shapes.resize(1);
    requests.push_back({{note.at, {1, 0}, 4, 4}, words.back().shapes, -1, false});
  }
  const auto spots = place_labels(requests, open);
  for (std::size_t i = 0; i < spots.size(); ++i) {
    if (!spots[i].placed) continue;
    fill(drawing, Path{}.polygon(spots[i].box), rgb(0xffffff, 0.85));
    write_spot(drawing, spots[i], words[i], size, ink::kProblem, true);
    field.taken.push_back(spots[i].box);
    field.taken.push_back(leader_box(spots[i].leader_from, spots[i].leader_to));
  }
}

}  // namespace

std::vector<LegendRow> draw_labels(Drawing& drawing, const Page& page, const Stock& stock, const scene::Scene& scene,
                                   const PlanOptions& options, const std::vector<Note>& notes) {
  LabelField field = make_field(page, stock, scene);
  if (options.dimensions) add_dimensions(field, page, stock);
  write_notes(drawing, page, notes, field);
  if (options.labels == PlanOptions::Labels::none) return {};
  Split who = split(stock, options);
  const bool beside = options.labels == PlanOptions::Labels::all;
  const double size = kSize * page.text;
  std::vector<LabelRequest> requests;
  std::vector<Wording> words;
  std::vector<std::string> texts;
  const std::vector<std::size_t> counts = count_stacks(stock, who.labelled, options);
  for (std::size_t k = 0; k < who.labelled.size(); ++k) {
    const std::size_t i = who.labelled[k];
    const Item& item = stock.items[i];
    texts.push_back(label_text(item, options.ids));
    if (counts[k] > 1) texts.back() += " × " + std::to_string(counts[k]);
    words.push_back(wording(texts.back(), size, false));
    requests.push_back({page.frame.page(item.box), words.back().shapes, static_cast<int>(i), true, beside,
                        item.symbol->mark ? 8.0 : 0.0, item.symbol->round});
  }
  auto spots = place_labels(requests, field);
  Keys keys;
  std::vector<LabelRequest> numbered;
  std::vector<Wording> number_words;
  for (std::size_t i = 0; i < spots.size(); ++i) {
    if (spots[i].placed) {
      write_spot(drawing, spots[i], words[i], size, ink::kText, false);
      field.taken.push_back(spots[i].box);
      if (!spots[i].inside) field.taken.push_back(leader_box(spots[i].leader_from, spots[i].leader_to));
    } else if (beside) {
      number_words.push_back(wording(keys.number(texts[i]), size, true));
      numbered.push_back({requests[i].box, number_words.back().shapes, requests[i].obstacle});
    }
  }
  spots = place_labels(numbered, field);
  for (std::size_t i = 0; i < spots.size(); ++i)
    if (spots[i].placed) write_spot(drawing, spots[i], number_words[i], size, ink::kText, true);
  std::vector<LegendRow> legend;
  for (const auto& [text, count] : keys.texts)
    legend.push_back({keys.numbers[text], count > 1 ? text + " × " + std::to_string(count) : text, nullptr});
  if (options.legend) legend.insert(legend.end(), who.counted.begin(), who.counted.end());
  return legend;
}

}  // namespace inhabit::render
