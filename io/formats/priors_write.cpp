#include "io/formats/object_writer.h"
#include "io/formats/priors_json.h"
#include "io/formats/priors_members.h"

namespace inhabit::io {
namespace {

class PriorsWriter : public ObjectWriter<PriorsWriter> {
 public:
  std::string text(const Priors& priors) {
    out_ = "{";
    key("format"), append_quoted(out_, kPriorsName);
    key("version"), append_number(out_, kPriorsVersion);
    if (priors.weights == CostWeights{}) key("weights"), write(priors.weights, {});
    members(priors);
    out_ += '}';
    return std::move(out_);
  }

 private:
  friend class ObjectWriter<PriorsWriter>;
  using ObjectWriter::write;

  void write(const std::array<double, 4>& faces, const Spec&) {
    object(Clearance{.front = faces[2], .back = faces[0], .left = faces[1], .right = faces[3]});
  }
  /// With every weight, so that people see what there is to edit.
  void write(const CostWeights& weights, const Spec&) {
    out_ += '{';
    for_each_member<CostWeights>([&](std::string_view name, auto pointer, const Spec& spec) {
      key(name);
      write(weights.*pointer, spec);
    });
    out_ += '}';
  }
};

}  // namespace

std::string write_priors(const Priors& priors) { return pretty_json(PriorsWriter().text(priors)); }

}  // namespace inhabit::io
