// SPDX-License-Identifier: Apache-2.0
#include "cli/program.h"
#include "parallel/denormals.h"

int main(int argc, char** argv) {
  parhelion::flushDenormals();
  parhelion::Tracers ownThreads;
  return parhelion::cli::runProgram(argc, argv, ownThreads);
}
