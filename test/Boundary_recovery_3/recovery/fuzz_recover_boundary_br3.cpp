// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

// Small inputs made of bytes, in all the modes with both kernels, judged by brute force. With libFuzzer
// (BR3_BUILD_FUZZER) the bytes come from there, and with BR3_FUZZ_MAIN from this program's own arguments:
//   --random N SEED [SECONDS]  N pseudo-random inputs, or as many as fit in the time; N consecutive SEEDs
//   --trace N SEED [SECONDS]   the same, with the bytes written before each run
//   --hex BYTES                one input, as it was reported
//   FILE...                    the inputs in these files

#undef NDEBUG

#include "recover_and_judge_br3.h"

#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <random>
#include <string>
#include <vector>

typedef std::vector<std::uint8_t> Bytes;

std::string to_hex(const std::uint8_t* data, const std::size_t size)
{
  std::string hex;
  for(std::size_t i = 0; i < size; ++i)
  {
    hex += "0123456789abcdef"[data[i] / 16];
    hex += "0123456789abcdef"[data[i] % 16];
  }
  return hex;
}

br3_test::Recovery_status judge(const std::uint8_t* data, const std::size_t size)
{
  const br3_test::Fuzz_case fuzz_case = br3_test::Fuzz_decoder(data, size)();
  try {
    return br3_test::recover_and_judge(fuzz_case);
  } catch(const std::exception& e) {
    std::cerr << "failed: " << e.what() << "\n" << fuzz_case.plc
              << "points inserted before: " << fuzz_case.are_points_inserted_before
              << "\ndefects listed first: " << fuzz_case.is_list_of_defects_wanted
              << "\n--hex " << to_hex(data, size) << std::endl;
    std::abort();
  }
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  judge(data, size);
  return 0;
}

#ifdef BR3_FUZZ_MAIN

Bytes random_bytes(const unsigned long seed)
{
  std::mt19937_64 rng(seed);
  Bytes bytes(24 + rng() % 120);
  for(std::uint8_t& b : bytes)
    b = static_cast<std::uint8_t>(rng() >> 56);
  return bytes;
}

int run_random(const int argc, char** argv, const bool is_traced)
{
  const unsigned long n = std::stoul(argv[2]), seed = std::stoul(argv[3]);
  const double limit = argc > 4 ? std::stod(argv[4]) : 1e9;
  const auto start = std::chrono::steady_clock::now();
  std::map<std::string, int> counts;
  for(unsigned long i = 0; i < n; ++i)
  {
    if(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() > limit)
      break;
    const Bytes bytes = random_bytes(seed + i);
    if(is_traced)
      std::cout << "--hex " << to_hex(bytes.data(), bytes.size()) << std::endl;
    ++counts[to_string(judge(bytes.data(), bytes.size()))];
  }
  for(const auto& c : counts)
    std::cout << c.second << " " << c.first << "\n";
  if(counts.empty())
    return 1;
  return counts["incomplete"] > 1 + counts["recovered"] / 1000 ? 1 : 0; // see Brute_force_checker::must_be_complete()
}

int main(int argc, char** argv)
{
  const std::string option = argc > 1 ? argv[1] : "";
  if(argc >= 4 && (option == "--random" || option == "--trace"))
    return run_random(argc, argv, option == "--trace");
  if(argc == 3 && option == "--hex")
  {
    const std::string hex = argv[2];
    Bytes bytes;
    for(std::size_t i = 0; i + 1 < hex.size(); i += 2)
      bytes.push_back(static_cast<std::uint8_t>(std::stoi(hex.substr(i, 2), nullptr, 16)));
    std::cout << to_string(judge(bytes.data(), bytes.size())) << "\n";
    return 0;
  }
  if(argc == 1)
    return 1;
  for(int i = 1; i < argc; ++i)
  {
    std::ifstream file(argv[i], std::ios::binary);
    if(! file)
      return 1;
    const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    judge(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
  }
  return 0;
}

#endif // BR3_FUZZ_MAIN
