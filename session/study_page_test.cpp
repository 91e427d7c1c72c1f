#include "session/study_page.h"

#include <doctest/doctest.h>

using namespace inhabit::session;
using namespace inhabit::scene;

namespace {

StudyPlan plan_of(std::vector<std::string> human, std::vector<std::string> synthesis) {
  return {"", "", {{"bedroom", std::move(human), {{"A1", std::move(synthesis)}}}}};
}

std::string trouble(const StudyPlan& plan) {
  const auto page = study_page(plan);
  return page ? "" : page.error().text();
}

}  // namespace

TEST_CASE("a study's page holds its pictures and reaches for nothing outside") {
  StudyPlan plan = plan_of({"exemplar/bedroom-1"}, {"exemplar/bedroom-2"});
  plan.title = "</script><b>&", plan.task = "Which?</script>";
  const auto page = study_page(plan);
  REQUIRE(page.ok());
  CHECK(page->starts_with("<!DOCTYPE html>"));
  CHECK(page->find("\"data:image/svg+xml;base64,") != std::string::npos);
  CHECK(page->find("http:") == std::string::npos);
  CHECK(page->find("https:") == std::string::npos);
  CHECK(page->find("default-src 'none'") != std::string::npos);
  CHECK(page->find("<title>&lt;/script&gt;&lt;b&gt;&amp;</title>") != std::string::npos);
  // The two scripts end where they should, whatever the plan says.
  std::size_t ends = 0;
  for (std::size_t at = page->find("</script>"); at != std::string::npos; at = page->find("</script>", at + 1)) ++ends;
  CHECK(ends == 2);
  CHECK(page->find('@') == std::string::npos);
  CHECK(*study_page(plan) == *page);
}

TEST_CASE("one picture is in the page once however often it is shown") {
  StudyPlan plan = plan_of({"exemplar/bedroom-1"}, {"exemplar/bedroom-2"});
  const std::size_t one = study_page(plan)->size();
  plan.scenes[0].syntheses.push_back({"A2", {"exemplar/bedroom-3"}});
  plan.scenes.push_back(plan.scenes[0]);
  plan.scenes[1].name = "again";
  CHECK(study_page(plan)->size() < 2 * one);
}

TEST_CASE("what cannot be compared is an error that names the picture or the pair") {
  CHECK(trouble(plan_of({"exemplar/bedroom-1"}, {"nowhere.png"})).starts_with("nowhere.png: "));
  CHECK(trouble(plan_of({"exemplar/bedrom-1"}, {"exemplar/bedroom-2"})).find("did you mean") != std::string::npos);
  CHECK(trouble(plan_of({"exemplar/bedroom-1"}, {"exemplar/bedroom-1"})).find("looks the same") != std::string::npos);
  CHECK(trouble(plan_of({"exemplar/bedroom-1"}, {"learned-bedroom"})).find("no place yet") != std::string::npos);
  CHECK(trouble(plan_of({"exemplar/bedroom"}, {"exemplar/bedroom-1"})).find("rooms") != std::string::npos);
  CHECK(trouble(plan_of({"exemplar/bedroom-1", "exemplar/bedroom-2"}, {"exemplar/bedroom-3"})).find("1 view,") !=
        std::string::npos);
}
