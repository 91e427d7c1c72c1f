#pragma once
#include "render/crowd_picture.h"
#include "session/crowd_pictures.h"

/// What pictures and films share.
namespace inhabit::session {

/// The fixes from job.from until job.until. Errors: there are none.
Result<scene::Trajectories> part_of(const scene::Trajectories& trajectories, const CrowdPictureJob& job);
render::CrowdPictureOptions picture_options(const scene::Trajectories& trajectories, const CrowdPictureJob& job);

}  // namespace inhabit::session
