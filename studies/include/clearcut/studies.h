// Research on the library: published tables computed anew, contests of methods. Not part of what is installed.
#pragma once

#include "studies/genetic/genetic_study.h"
#include "studies/genetic/island_runs.h"
#include "studies/method_study.h"
#include "studies/reproduce/page/reproduction_page.h"
#include "studies/reproduce/reproduce.h"
#include "studies/reproduce/reproduce_parts.h"
