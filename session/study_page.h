#pragma once
#include <string>
#include <string_view>

#include "scene/study.h"
#include "session/document.h"

/// A study as one page that needs neither server nor network (`inhabit study make`, docs/study.md).
namespace inhabit::session {

struct StudyPageOptions {
  std::string folder;  ///< where the plan's relative paths begin; empty: here
  double grey = 1;     ///< seconds of grey between two pairs
  bool labels = true;  ///< names in the furniture of scenes, where they fit
};

/// The plan in a file. Errors name the place.
Result<StudyPlan> open_study_plan(const std::string& path);

/// The page, all its pictures inside. PNG, JPEG, GIF, WebP and SVG files are taken as they are, anything else is a
/// scene and is drawn without title, verdict and dimensions, which could give away whose it is. Errors (`where` is the
/// picture's file): not there, neither picture nor scene, a scene of several rooms or with things that have no place; a
/// synthesis with another number of views than the human design, or with the same pictures.
Result<std::string> study_page(const StudyPlan& plan, const StudyPageOptions& options = {});

/// What the page is made of, with @TITLE@, @STYLE@, @STUDY@ and @SCRIPT@ in the first; cmake/embed_study_page.cmake
/// writes them.
struct StudyPageParts {
  std::string_view html, css, js;
};
StudyPageParts study_page_parts();

}  // namespace inhabit::session
