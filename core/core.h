#pragma once
/// Everything that every layer needs; other headers of core are included where they are used.
#include "core/id.h"
#include "core/result.h"
