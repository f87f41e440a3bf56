// SPDX-License-Identifier: MIT
#include "ubf/testing.hpp"

namespace eyrie::ubf {
#define EYRIE_UBF_TESTED(Node) template class Node<testing::State, testing::Action>;
#include "ubf/testing_nodes.inc"
#undef EYRIE_UBF_TESTED
template class Trace<testing::Action>;
template void add_standard_nodes(Registry<testing::State, testing::Action>&);
}  // namespace eyrie::ubf
