#include "order/genetic/genome.h"

namespace clearcut::order {

double shared_edges(const Genome& a, const Genome& b, bool closed, double enough) {
  const int n = a.size();
  const int edges = closed ? n : n - 1;
  if (edges <= 0) return 1;
  int shared = 0;
  for (int p = 0; p < edges; ++p) {
    shared += has_edge(b, a.at(p), a.at(p + 1 == n ? 0 : p + 1), closed) ? 1 : 0;
    if (shared > enough * edges) break;
  }
  return static_cast<double>(shared) / edges;
}

}  // namespace clearcut::order
