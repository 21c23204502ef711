// SPDX-License-Identifier: Apache-2.0
// The same program for many processes, as mpirun starts them. Rank 0 is the program; the others trace for it.
#include "cli/program.h"
#include "parallel/denormals.h"
#include "render/ranks/rank_tracers.h"

int main(int argc, char** argv) {
  using namespace parhelion;
  flushDenormals();
  Ranks ranks(argc, argv);
  if (ranks.rank() > 0) {
    serveRank0(ranks);
    return 0;
  }
  RankTracers allRanks(ranks);
  return cli::runProgram(argc, argv, allRanks);
}
