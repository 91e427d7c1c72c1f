// Moves everything in a home a little and writes it, with a table of where every piece should be: the other half of
// tests/sweethome3d_oracle.py. Usage: sweethome3d_oracle HOME OUT.sh3d OUT.tsv, or --new OUT.sh3d OUT.tsv.
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>

#include "io/formats/sweethome3d.h"
#include "io/formats/sweethome3d_plan.h"

using namespace inhabit;

namespace {

void print(std::FILE* out, const std::vector<io::sh3d::Piece>& pieces) {
  for (const auto& p : pieces) {
    if (p.type == io::sh3d::Piece::Type::group) {
      print(out, p.children);
    } else {
      std::fprintf(out, "%s\t%.4f\t%.4f\t%.4f\t%.6f\n", p.name.c_str(), p.p.x, p.p.y, p.elevation, p.angle);
    }
  }
}

scene::Scene simple_room() {
  scene::Scene scene;
  scene.name = "Bob's room";
  scene.space.outline = {{0, 0}, {4, 0}, {4, 3}, {0, 3}};
  scene.space.doors.push_back({"door", 0, 0.5, 0.9});
  scene.space.windows.push_back({"window", 2, 1, 1.2});
  for (int i = 0; i < 3; ++i) {
    scene::Object o;
    o.id = o.name = std::string("thing ").append(std::to_string(i));
    o.position = geometry::Vec3{1.0 + i, 1, 0.2 * i};
    o.angle = i;
    scene.objects.push_back(o);
  }
  return scene;
}

core::Result<io::Sh3dFile> moved_home(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  const auto home = io::open_sh3d({std::istreambuf_iterator<char>(in), {}});
  if (!home) return home.error();
  auto scenes = io::rooms(*home);
  if (!scenes) return scenes.error();
  for (auto& scene : *scenes) {
    for (auto& o : scene.objects) {
      if (o.fixed) continue;
      o.position->x += 0.123;
      o.angle = core::wrap_angle(*o.angle + 0.5);
    }
  }
  return io::write_sh3d(*home, *scenes);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  const auto file = std::string(argv[1]) == "--new" ? io::write_sh3d_new(simple_room()) : moved_home(argv[1]);
  if (!file) return std::fprintf(stderr, "%s\n", file.error().text().c_str()), 1;
  std::ofstream(argv[2], std::ios::binary) << file->bytes;
  const auto plan = io::sh3d::read_plan(file->xml);
  if (!plan) return 1;
  std::FILE* out = std::fopen(argv[3], "w");
  if (out == nullptr) return 1;
  print(out, plan->pieces);
  std::fclose(out);
  std::printf("%zu moved, %zu added\n", file->moved, file->added);
  return 0;
}
