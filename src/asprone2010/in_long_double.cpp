#include "asprone2010/in_each_precision.hpp"
#include "asprone2010/list_of_formulations.hpp"

ASPRONE2010_IN_PRECISION(template, long double)
