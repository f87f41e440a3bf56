// SPDX-License-Identifier: MIT
#include "pilot/policy/tensors.hpp"

#include <fmt/ranges.h>

#include <algorithm>

#include "core/text.hpp"
#include "core/yaml.hpp"

namespace eyrie::pilot {
namespace {

constexpr std::size_t kLength = 8, kMostDimensions = 8;

std::optional<std::vector<std::size_t>> whole_numbers(const Value* list, std::size_t most) {
  if (!list || !list->is_list() || list->items.size() > most)
    return std::nullopt;
  std::vector<std::size_t> numbers;
  for (const Value& item : list->items) {
    const auto number =
        item.is_scalar() ? number_from<std::size_t>(item.text) : std::optional<std::size_t>();
    if (!number)
      return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

/// Bytes of a number; 0 if the type is not known.
std::size_t size_of(std::string_view type) {
  if (type == "F64" || type == "I64" || type == "U64")
    return 8;
  if (type == "F32" || type == "I32" || type == "U32")
    return 4;
  if (type == "F16" || type == "BF16" || type == "I16" || type == "U16")
    return 2;
  return type == "I8" || type == "U8" || type == "BOOL" ? 1 : 0;
}

/// The tensor of an entry, or what is wrong with it.
std::string read_tensor(const Value::Entry& entry, std::string_view data, Tensor& tensor) {
  const Value* type = entry.value.find("dtype");
  const auto shape = whole_numbers(entry.value.find("shape"), kMostDimensions);
  const auto place = whole_numbers(entry.value.find("data_offsets"), 2);
  if (!type || !type->is_scalar() || !shape || !place || place->size() != 2)
    return fmt::format("tensor {} needs dtype, shape and data_offsets", quote(entry.key));
  const std::size_t begin = (*place)[0], end = (*place)[1];
  if (begin > end || end > data.size())
    return fmt::format("tensor {} is at {} to {} of {} bytes", quote(entry.key), begin, end,
                       data.size());
  tensor = {entry.key, type->text, *shape, data.substr(begin, end - begin)};
  std::size_t bytes = size_of(tensor.type);
  if (bytes == 0)
    return {};  // nobody here can use it
  const bool holds_nothing = std::find(shape->begin(), shape->end(), 0U) != shape->end();
  for (const std::size_t dimension : *shape)
    if (holds_nothing || bytes > tensor.bytes.size() / dimension)
      bytes = holds_nothing ? 0 : tensor.bytes.size() + 1;  // no product that is too large
    else
      bytes *= dimension;
  if (bytes != tensor.bytes.size())
    return fmt::format("tensor {} of shape {} and type {} does not fit into {} bytes",
                       quote(entry.key), tensor.shape_text(), tensor.type, tensor.bytes.size());
  return {};
}

/// By the format's rule the tensors fill the data, without a hole and none over another; or "".
std::string problem_of_places(const std::vector<Tensor>& tensors, std::string_view data) {
  std::vector<const Tensor*> in_order;
  for (const Tensor& tensor : tensors)
    in_order.push_back(&tensor);
  std::sort(in_order.begin(), in_order.end(), [](const Tensor* a, const Tensor* b) {
    return std::pair(a->bytes.data(), a->bytes.size()) <
           std::pair(b->bytes.data(), b->bytes.size());
  });
  const char* at = data.data();
  for (const Tensor* tensor : in_order) {
    if (tensor->bytes.data() != at)
      return fmt::format("tensor {} does not begin where the one before it ends",
                         quote(tensor->name));
    at += tensor->bytes.size();
  }
  const auto left = data.data() + data.size() - at;
  return left ? fmt::format("{} {} behind the last tensor", left, left == 1 ? "byte" : "bytes")
              : "";
}

}  // namespace

std::string Tensor::shape_text() const {
  return fmt::format("[{}]", fmt::join(shape, ", "));
}

std::optional<TensorFile> TensorFile::read(std::string bytes, FileName file,
                                           Diagnostics& diagnostics) {
  const std::size_t before = diagnostics.count();
  TensorFile out;
  out.file_ = file;
  out.bytes_ = std::make_shared<const std::string>(std::move(bytes));
  const std::string_view all = *out.bytes_;
  std::uint64_t length = 0;
  for (std::size_t i = 0; i < kLength && i < all.size(); ++i)
    length |= std::uint64_t{static_cast<unsigned char>(all[i])} << (8 * i);
  const bool is_whole = all.size() >= kLength && length <= all.size() - kLength;
  if (!is_whole || length > kLargestHeader)
    return diagnostics.error({file}, is_whole
                                         ? "its header is larger than 1 MB"
                                         : "no file of tensors (.safetensors), or one that is cut");
  const auto header_size = static_cast<std::size_t>(length);
  const std::string_view data = all.substr(kLength + header_size);
  Diagnostics wrong;
  const Value header =
      parse_yaml(all.substr(kLength, header_size), file.text(), wrong);  // JSON is YAML
  constexpr std::string_view kNotYaml = "not YAML";
  for (const auto& [where, message] : wrong.sorted())
    diagnostics.error(where, message.starts_with(kNotYaml)
                                 ? "the header is not JSON" + message.substr(kNotYaml.size())
                                 : message);
  if (diagnostics.count() == before && !header.is_map())
    diagnostics.error({file}, "the header is no JSON object");
  for (const Value::Entry& entry : header.entries) {
    if (entry.key == "__metadata__") {
      for (const Value::Entry& word : entry.value.entries)
        out.words_[word.key] = word.value.text;
      continue;
    }
    Tensor tensor;
    if (const std::string problem = read_tensor(entry, data, tensor); !problem.empty())
      diagnostics.error({file}, problem);
    out.tensors_.push_back(std::move(tensor));
  }
  if (diagnostics.count() == before)
    if (const std::string problem = problem_of_places(out.tensors_, data); !problem.empty())
      diagnostics.error({file}, problem);
  return diagnostics.count() == before ? std::optional(std::move(out)) : std::nullopt;
}

const Tensor* TensorFile::find(std::string_view name) const {
  const auto found = std::ranges::find(tensors_, name, &Tensor::name);
  return found == tensors_.end() ? nullptr : &*found;
}

std::vector<std::string> TensorFile::names() const {
  return listed(tensors_, &Tensor::name);
}

std::optional<std::string> TensorFile::word(const std::string& name) const {
  const auto found = words_.find(name);
  return found == words_.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace eyrie::pilot
