#include "session/study_page.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "core/hash.h"
#include "core/text.h"
#include "io/file.h"
#include "io/formats/study.h"
#include "render/plan.h"

namespace inhabit::session {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kTask =
    "You will see two arrangements of the same room, side by side, and then the next two.\n\n"
    "Choose the one in which you would prefer to live, stay, work or visit, whatever the room is for.";

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) text += k <= count ? kDigits[group >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

/// By the first bytes; empty when they are no picture that browsers show.
std::string_view picture_type(std::string_view bytes) {
  if (bytes.starts_with("\x89PNG\r\n")) return "image/png";
  if (bytes.starts_with("\xff\xd8\xff")) return "image/jpeg";
  if (bytes.starts_with("GIF8")) return "image/gif";
  if (bytes.starts_with("RIFF") && bytes.substr(0, 12).ends_with("WEBP")) return "image/webp";
  const std::string_view head = bytes.substr(0, 1000);
  if (bytes.starts_with("<") && head.find("<svg") != std::string_view::npos) return "image/svg+xml";
  return "";
}

bool named_as_picture(const std::string& name) {
  constexpr std::array<std::string_view, 6> kExtensions = {".png", ".jpg", ".jpeg", ".gif", ".webp", ".svg"};
  std::string extension = std::filesystem::path(name).extension().string();
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return std::ranges::find(kExtensions, extension) != kExtensions.end();
}

Result<std::string> drawn(const std::string& path, const StudyPageOptions& options) {
  const Result<Document> document = open_document(path);
  if (!document) return document.error();
  if (document->scenes.size() != 1)
    return invalid("", "holds " + std::to_string(document->scenes.size()) +
                           " rooms, and a picture shows one (inhabit convert --room takes it out)");
  const Scene& scene = document->scenes.front();
  const auto nowhere = std::ranges::count_if(scene.objects, [](const Object& o) { return !o.position; });
  if (nowhere > 0)
    return invalid("", std::to_string(nowhere) + " of its " + std::to_string(scene.objects.size()) +
                           " things have no place yet (inhabit furnish arranges them)");
  render::PlanOptions plan;
  plan.labels = options.labels ? render::PlanOptions::Labels::inside : render::PlanOptions::Labels::none;
  plan.title = plan.dimensions = plan.scale_bar = plan.verdict = plan.legend = false;
  plan.background = render::rgb(0xffffff);
  render::Drawing drawing = render::draw_plan(scene, plan);
  drawing.title.clear();
  return render::encode(drawing, render::Format::svg);
}

/// Every picture once, as data URIs.
class Pictures {
 public:
  explicit Pictures(const StudyPageOptions& options) : options_(options) {}

  /// Numbers of the pictures.
  Result<std::vector<std::size_t>> add(const std::vector<std::string>& names) {
    std::vector<std::size_t> indices;
    for (const std::string& name : names) {
      Result<std::string> uri = load(name);
      if (!uri) {
        Error error = uri.error();
        error.where = error.where.empty() || error.where == name ? name : name + ": " + error.where;
        return error;
      }
      const auto found = std::ranges::find(uris, *uri);
      indices.push_back(static_cast<std::size_t>(found - uris.begin()));
      if (found == uris.end()) uris.push_back(std::move(*uri));
    }
    return indices;
  }

  std::vector<std::string> uris;

 private:
  Result<std::string> load(const std::string& name) const {
    const std::string beside = (std::filesystem::path(options_.folder) / name).string();
    std::error_code error;
    const std::string path = std::filesystem::exists(beside, error) ? beside : name;
    Result<std::string> bytes = std::string();
    if (named_as_picture(name)) {
      bytes = io::read_file(beside);
      if (!bytes) return Error{bytes.error().code, bytes.error().message, ""};
      if (picture_type(*bytes).empty()) return invalid("", "is no PNG, JPEG, GIF, WebP or SVG picture");
    } else {
      bytes = drawn(path, options_);
    }
    if (!bytes) return bytes.error();
    return "data:" + std::string(picture_type(*bytes)) + ";base64," + base64(*bytes);
  }

  const StudyPageOptions& options_;
};

std::string views(std::size_t count) { return std::to_string(count) + (count == 1 ? " view" : " views"); }

/// What the page's script needs to know.
Result<Json> study_data(const StudyPlan& plan, const StudyPageOptions& options) {
  Pictures pictures(options);
  Json pairs = Json::array();
  for (const StudyScene& scene : plan.scenes) {
    const auto human = pictures.add(scene.human);
    if (!human) return human.error();
    std::set<std::string_view> names;
    for (const StudyPlate& plate : scene.syntheses) {
      const std::string both = "scene \"" + scene.name + "\", synthesis \"" + plate.name + "\"";
      if (!names.insert(plate.name).second) return invalid(both, "is there already");
      const auto synthesis = pictures.add(plate.pictures);
      if (!synthesis) return synthesis.error();
      if (synthesis->size() != human->size())
        return invalid(both, "has " + views(synthesis->size()) + ", the human design " + views(human->size()));
      if (*synthesis == *human) return invalid(both, "looks the same as the human design");
      pairs.push_back({{"scene", scene.name}, {"synthesis", plate.name}, {"human", *human}, {"pictures", *synthesis}});
    }
  }
  Json data;
  data["title"] = plan.title.empty() ? "Which arrangement do you prefer?" : plan.title;
  data["task"] = plan.task.empty() ? std::string(kTask) : plan.task;
  data["grey"] = options.grey;
  data["pairs"] = std::move(pairs);
  data["pictures"] = pictures.uris;
  core::Digest digest;
  digest.add(data.dump());
  constexpr std::string_view kHex = "0123456789abcdef";
  std::string id;
  for (int shift = 60; shift >= 0; shift -= 4) id += kHex[digest.value() >> shift & 15];
  data["study"] = id;
  return data;
}

std::string escaped_title(std::string_view text) {
  std::string out;
  for (const char c : text) out += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
  return out;
}

/// JSON that may stand in a script element: nothing in it can end the element.
std::string script_json(const Json& data) {
  std::string out;
  for (const char c : data.dump()) c == '<' ? out += "\\u003c" : out += c;
  return out;
}

}  // namespace

Result<StudyPlan> open_study_plan(const std::string& path) {
  const Result<std::string> bytes = io::read_file(path);
  if (!bytes) return Error{bytes.error().code, bytes.error().message, ""};
  return io::read_study_plan(*bytes);
}

Result<std::string> study_page(const StudyPlan& plan, const StudyPageOptions& options) {
  const Result<Json> data = study_data(plan, options);
  if (!data) return data.error();
  const StudyPageParts parts = study_page_parts();
  std::string page;
  std::string_view rest = parts.html;
  while (!rest.empty()) {
    const std::size_t at = rest.find('@'), end = at == std::string_view::npos ? at : rest.find('@', at + 1);
    page += rest.substr(0, at);
    if (at == std::string_view::npos) break;
    const std::string_view mark = rest.substr(at + 1, end - at - 1);
    if (mark == "TITLE") page += escaped_title((*data)["title"].get<std::string>());
    if (mark == "STYLE") page += parts.css;
    if (mark == "STUDY") page += script_json(*data);
    if (mark == "SCRIPT") page += parts.js;
    rest.remove_prefix(end + 1);
  }
  return page;
}

}  // namespace inhabit::session
