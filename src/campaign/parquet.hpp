// SPDX-License-Identifier: MIT
#pragma once
/// \file  The table of the results as Parquet, by DuckDB's library where that is installed.
#include <memory>

#include "campaign/store.hpp"

namespace eyrie::campaign {

inline constexpr const char* kParquetName = "results.parquet";

class Parquet {
 public:
  /// `library` is a file, or a name that the system looks for. Throws disk::Refused if it cannot be
  /// opened, and says how to get it.
  explicit Parquet(const std::string& library);
  ~Parquet();

  /// The rows and columns of results.csv: cell, replicate, seed and steps are integers, outcome,
  /// hash and factors that are no numbers texts, everything else doubles; NULL where nothing
  /// applies. Throws disk::Failed.
  void write(Database& database, disk::OutputFile& file);

 private:
  void run(const std::string& sql);

  struct Calls;
  std::unique_ptr<Calls> calls_;
};

}  // namespace eyrie::campaign
