/* Counts what a program asks of MPI, rank by rank, through MPI's profiling interface (LD_PRELOAD). Counting begins at
 * MPI_Pcontrol(1) and ends at MPI_Pcontrol(0), with which percuss brackets its time loop. MPI_Finalize writes, to the
 * file named by PERCUSS_MPI_COUNTS, a heading and a row a rank:
 *   messages, bytes: point-to-point, whatever their purpose; those of prepared requests count when they are started
 *   collectives:     calls of collective operations
 *   hops:            the sum of ceil(log2(ranks of the communicator)) over these calls: how many latencies a tree takes
 */
#include <mpi.h>
#include <stdio.h>
#include <stdlib.h>

enum { messages, bytes, collectives, hops, num_counts };

static long long counts[num_counts];
static int counting = 0;

static void count_collective(MPI_Comm comm) {
  int size = 1;
  if (!counting) return;
  PMPI_Comm_size(comm, &size);
  counts[collectives] += 1;
  for (int reached = 1; reached < size; reached *= 2) counts[hops] += 1;
}

static void count_message(int count, MPI_Datatype type) {
  int size = 0;
  if (!counting) return;
  PMPI_Type_size(type, &size);
  counts[messages] += 1;
  counts[bytes] += (long long)count * size;
}

int MPI_Pcontrol(const int level, ...) {
  counting = level == 1;
  return MPI_SUCCESS;
}

int MPI_Isend(const void* buffer, int count, MPI_Datatype type, int to, int tag, MPI_Comm comm, MPI_Request* request) {
  count_message(count, type);
  return PMPI_Isend(buffer, count, type, to, tag, comm, request);
}

int MPI_Issend(const void* buffer, int count, MPI_Datatype type, int to, int tag, MPI_Comm comm, MPI_Request* request) {
  count_message(count, type);
  return PMPI_Issend(buffer, count, type, to, tag, comm, request);
}

/* Prepared sends and their bytes. */
enum { most_prepared = 1 << 16 };
static MPI_Request prepared[most_prepared];
static int prepared_bytes[most_prepared];
static int num_prepared = 0;

static int find_prepared(MPI_Request request) {
  int i = 0;
  while (i < num_prepared && prepared[i] != request) ++i;
  return i;
}

int MPI_Send_init(const void* buffer, int count, MPI_Datatype type, int to, int tag, MPI_Comm comm,
                  MPI_Request* request) {
  const int code = PMPI_Send_init(buffer, count, type, to, tag, comm, request);
  int size = 0;
  PMPI_Type_size(type, &size);
  if (num_prepared < most_prepared) {
    prepared[num_prepared] = *request;
    prepared_bytes[num_prepared++] = count * size;
  }
  return code;
}

int MPI_Request_free(MPI_Request* request) {
  const int i = find_prepared(*request);
  if (i < num_prepared) {
    prepared[i] = prepared[--num_prepared];
    prepared_bytes[i] = prepared_bytes[num_prepared];
  }
  return PMPI_Request_free(request);
}

int MPI_Startall(int count, MPI_Request* requests) {
  for (int r = 0; r < count; ++r) {
    const int i = find_prepared(requests[r]);
    if (i < num_prepared) count_message(prepared_bytes[i], MPI_BYTE);
  }
  return PMPI_Startall(count, requests);
}

int MPI_Comm_create_group(MPI_Comm comm, MPI_Group group, int tag, MPI_Comm* made) {
  const int code = PMPI_Comm_create_group(comm, group, tag, made);
  if (*made != MPI_COMM_NULL) count_collective(*made);
  return code;
}

int MPI_Allreduce(const void* send, void* receive, int count, MPI_Datatype type, MPI_Op op, MPI_Comm comm) {
  count_collective(comm);
  return PMPI_Allreduce(send, receive, count, type, op, comm);
}

int MPI_Iallreduce(const void* send, void* receive, int count, MPI_Datatype type, MPI_Op op, MPI_Comm comm,
                   MPI_Request* request) {
  count_collective(comm);
  return PMPI_Iallreduce(send, receive, count, type, op, comm, request);
}

int MPI_Reduce_scatter_block(const void* send, void* receive, int count, MPI_Datatype type, MPI_Op op, MPI_Comm comm) {
  count_collective(comm);
  return PMPI_Reduce_scatter_block(send, receive, count, type, op, comm);
}

int MPI_Allgather(const void* send, int send_count, MPI_Datatype send_type, void* receive, int receive_count,
                  MPI_Datatype receive_type, MPI_Comm comm) {
  count_collective(comm);
  return PMPI_Allgather(send, send_count, send_type, receive, receive_count, receive_type, comm);
}

int MPI_Bcast(void* buffer, int count, MPI_Datatype type, int root, MPI_Comm comm) {
  count_collective(comm);
  return PMPI_Bcast(buffer, count, type, root, comm);
}

int MPI_Barrier(MPI_Comm comm) {
  count_collective(comm);
  return PMPI_Barrier(comm);
}

int MPI_Ibarrier(MPI_Comm comm, MPI_Request* request) {
  count_collective(comm);
  return PMPI_Ibarrier(comm, request);
}

static void write_counts(const char* path, const long long* rows, int ranks) {
  FILE* file = fopen(path, "w");
  if (file == NULL) {
    perror(path);
    return;
  }
  fprintf(file, "rank,messages,bytes,collectives,hops\n");
  for (int r = 0; r < ranks; ++r) {
    fprintf(file, "%d", r);
    for (int c = 0; c < num_counts; ++c) fprintf(file, ",%lld", rows[r * num_counts + c]);
    fprintf(file, "\n");
  }
  fclose(file);
}

int MPI_Finalize(void) {
  const char* path = getenv("PERCUSS_MPI_COUNTS");
  int rank = 0, ranks = 1;
  PMPI_Comm_rank(MPI_COMM_WORLD, &rank);
  PMPI_Comm_size(MPI_COMM_WORLD, &ranks);
  long long* rows = malloc(sizeof(counts) * (size_t)ranks);
  PMPI_Gather(counts, num_counts, MPI_LONG_LONG, rows, num_counts, MPI_LONG_LONG, 0, MPI_COMM_WORLD);
  if (rank == 0 && path != NULL) write_counts(path, rows, ranks);
  free(rows);
  return PMPI_Finalize();
}
