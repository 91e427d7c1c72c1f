#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/format_table.h"
#include "scene/scene.h"

/// What a job works on: a scene from a file or built in, or the rooms of a home.
namespace inhabit::session {
using namespace scene;

/// Its `home` is where the rooms came from, to be written back into it.
struct Document : io::Content {
  std::string name;  ///< as it was asked for
};

/// A scene that the program carries: scenes/<name>.json; furnished rooms to learn from are called exemplar/<name>-<k>
/// and come from scenes/exemplar/.
struct BuiltinScene {
  std::string_view name, json;
};
/// In order of name; cmake/embed_scenes.cmake writes them.
std::span<const BuiltinScene> builtin_scenes();

struct OpenOptions {
  std::string asset_database;  ///< sizes of ProcTHOR's pieces, for its houses
  std::size_t line = 0;        ///< the house of a file that has one per line, from 1; 0: all
};

/// The file of this name; when there is none, the built-in scene, or all of the set exemplar/<name>. Errors offer the
/// nearest built-in name.
Result<Document> open_document(const std::string& name, const OpenOptions& options = {});
/// Bytes of any format of io/format_table.h.
Result<Document> read_document(std::string_view file_name, std::string bytes, const OpenOptions& options = {});
/// The document in the format that the file name's extension says. Errors: a format that is not written, several rooms
/// for a format that holds one scene (it names them).
Result<std::string> write_document(const Document& document, std::string_view file_name);

/// The rooms called `names` alone, in document order; all of them when `names` is empty. Errors name the rooms there
/// are.
Result<Document> only_rooms(Document document, std::span<const std::string> names);

/// Whether save_file has a chance: the folder is there and may be written to. For asking before long work.
Status can_save(const std::string& path);
/// Writes the bytes beside the file and renames, so that an existing file stays whole whatever happens.
Status save_file(const std::string& path, std::string_view bytes);

}  // namespace inhabit::session
