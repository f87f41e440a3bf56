// SPDX-License-Identifier: MIT
/// \file  MPI for campaigns, behind the calls of campaign/link.hpp: a library of its own, so that
/// the program needs none.
#include <mpi.h>

#include "campaign/link.hpp"

namespace {

MPI_Status found;  ///< by the last poll

void send(int to, const char* bytes, int count) {
  MPI_Send(bytes, count, MPI_BYTE, to, 0, MPI_COMM_WORLD);
}
int poll(int* from) {
  int any = 0, count = 0;
  MPI_Iprobe(MPI_ANY_SOURCE, 0, MPI_COMM_WORLD, &any, &found);
  if (!any)
    return -1;
  MPI_Get_count(&found, MPI_BYTE, &count);
  *from = found.MPI_SOURCE;
  return count;
}
void receive(int from, char* bytes, int count) {
  MPI_Recv(bytes, count, MPI_BYTE, from, 0, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
}
void end() {
  MPI_Finalize();
}

}  // namespace

extern "C" __attribute__((visibility("default"))) const eyrie::campaign::MpiCalls*
eyrie_mpi_open() {
  static eyrie::campaign::MpiCalls calls{
      eyrie::campaign::kMpiCalls, 0, 0, send, poll, receive, end};
  int threads = 0;
  // threads fly; messages are those of the thread that opens this
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &threads);
  MPI_Comm_rank(MPI_COMM_WORLD, &calls.rank);
  MPI_Comm_size(MPI_COMM_WORLD, &calls.size);
  return &calls;
}
