#include "crowd/model_table.h"
#include "crowd/simulation.h"
