// SPDX-License-Identifier: MIT
#pragma once
/// \file  Files of tensors: the format safetensors.
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/diagnostics.hpp"

namespace eyrie::pilot {

/// A named array of numbers in a file.
struct Tensor {
  std::string name;
  std::string type;  ///< of a number: "F32"
  std::vector<std::size_t> shape;
  std::string_view bytes;  ///< of the file, the last index fastest

  /// "[64, 24]"
  [[nodiscard]] std::string shape_text() const;
};

/// The tensors and the words of one file: eight bytes with the length of a header, little-endian;
/// the header, a JSON object from names to {"dtype", "shape", "data_offsets"} and, under
/// "__metadata__", from words to words; then the data
/// (https://github.com/huggingface/safetensors, "Format").
class TensorFile {
 public:
  static constexpr std::size_t kLargestHeader = 1 << 20;

  /// Nothing after reporting why: a file that is cut, a header that is none, a tensor that lies
  /// beyond the data or is not as large as its shape says. Any bytes are safe.
  [[nodiscard]] static std::optional<TensorFile> read(std::string bytes, FileName file,
                                                      Diagnostics& diagnostics);

  /// The tensor of that name, or null.
  [[nodiscard]] const Tensor* find(std::string_view name) const;
  [[nodiscard]] std::vector<std::string> names() const;
  /// The word of that name, or nothing.
  [[nodiscard]] std::optional<std::string> word(const std::string& name) const;
  [[nodiscard]] FileName file() const { return file_; }

 private:
  FileName file_;
  std::shared_ptr<const std::string> bytes_;  ///< what the tensors look into
  std::vector<Tensor> tensors_;
  std::map<std::string, std::string> words_;
};

}  // namespace eyrie::pilot
