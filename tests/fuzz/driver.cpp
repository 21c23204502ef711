// SPDX-License-Identifier: Apache-2.0
// Stands in for libFuzzer, whose targets it takes: shows a target all files of a folder, and then mutations of them,
// the same ones each time.
//   fuzz_NAME CORPUS [MUTATIONS [SEED]]
// An input that takes longer than the target allows, or makes the process larger than a gigabyte, ends it like a crash.
// The input is left in a file, whose name is printed.
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

namespace fs = std::filesystem;

std::string current;  // what the target sees

/// Leaves the input behind. Handlers do no more than they may: they write.
void leave(int signal) {
  const char name[] = "fuzz-input";
  if (std::FILE* file = std::fopen(name, "wb")) {
    std::fwrite(current.data(), 1, current.size(), file);
    std::fclose(file);
  }
  std::fprintf(stderr, "ended by signal %d (%s) on %s, %zu bytes\n", signal, ::strsignal(signal), name, current.size());
  std::_Exit(1);
}

void show(const std::string& input) {
  current = input;
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(current.data()), current.size());
}

std::string mutated(std::string input, const std::vector<std::string>& corpus, std::mt19937_64& random) {
  const auto below = [&random](std::size_t count) { return static_cast<std::size_t>(random() % count); };
  for (std::size_t changes = 1 + below(6); changes > 0; --changes) {
    const std::size_t at = below(input.size() + 1);
    const std::string& other = corpus[below(corpus.size())];
    switch (below(6)) {
      case 0:  // another byte
        if (at < input.size()) input[at] = static_cast<char>(random());
        break;
      case 1:  // one bit
        if (at < input.size()) input[at] = static_cast<char>(input[at] ^ (1 << below(8)));
        break;
      case 2:  // the borders of integers
        if (at < input.size()) input[at] = "\x00\x01\x7f\x80\xfe\xff"[below(6)];
        break;
      case 3:  // something left out
        input.erase(at, 1 + below(16));
        break;
      case 4:  // a part of another
        input.insert(at, other, below(other.size() + 1), below(64));
        break;
      default:  // cut short, rarely
        if (below(8) == 0) input.resize(at);
    }
  }
  return input;
}

std::vector<std::string> filesIn(const fs::path& folder) {
  std::vector<fs::path> paths;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  std::vector<std::string> all;
  for (const fs::path& path : paths) {
    std::ifstream file(path, std::ios::binary);
    all.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }
  return all;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return std::fprintf(stderr, "usage: fuzz_NAME CORPUS [MUTATIONS [SEED]]\n"), 2;
#if !defined(__SANITIZE_ADDRESS__)  // which itself takes terabytes of addresses
  const rlimit most{1'000'000'000, 1'000'000'000};
  ::setrlimit(RLIMIT_AS, &most);
#endif
  for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGILL, SIGVTALRM}) std::signal(signal, leave);
  const std::vector<std::string> corpus = filesIn(argv[1]);
  if (corpus.empty()) return std::fprintf(stderr, "%s holds no inputs\n", argv[1]), 2;
  const long mutations = argc > 2 ? std::atol(argv[2]) : 0;
  std::mt19937_64 random(argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1);
  for (const std::string& input : corpus) show(input);
  for (long i = 0; i < mutations; ++i) show(mutated(corpus[random() % corpus.size()], corpus, random));
  std::printf("%zu inputs and %ld mutations\n", corpus.size(), mutations);
  return 0;
}
