#include "bearing/gmres.hpp"

#include <cmath>

namespace shellback::bearing {
namespace {

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  double s = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) s += a[k] * b[k];
  return s;
}

void add(std::vector<double>& y, double f, const std::vector<double>& x) {
  for (std::size_t k = 0; k < y.size(); ++k) y[k] += f * x[k];
}

}  // namespace

KrylovResult gmres(const LinearOperator& apply, const std::vector<double>& b, double tolerance,
                   int most) {
  KrylovResult out;
  out.x.assign(b.size(), 0.0);
  const double norm = std::sqrt(dot(b, b));
  if (norm == 0.0) return out;
  std::vector<std::vector<double>> v{b};
  for (double& x : v[0]) x /= norm;
  std::vector<std::vector<double>> h;  // columns of the rotated Hessenberg matrix
  std::vector<double> cosine, sine, rest{norm};
  while (out.iterations < most) {
    const int k = out.iterations;
    std::vector<double> w = apply(v[k]);
    std::vector<double> column(k + 2);
    for (int i = 0; i <= k; ++i) {
      column[i] = dot(w, v[i]);
      add(w, -column[i], v[i]);
    }
    column[k + 1] = std::sqrt(dot(w, w));
    const double next = column[k + 1];
    for (int i = 0; i < k; ++i) {
      const double t = cosine[i] * column[i] + sine[i] * column[i + 1];
      column[i + 1] = -sine[i] * column[i] + cosine[i] * column[i + 1];
      column[i] = t;
    }
    const double r = std::hypot(column[k], column[k + 1]);
    if (r == 0.0) break;
    cosine.push_back(column[k] / r);
    sine.push_back(column[k + 1] / r);
    column[k] = r;
    rest.push_back(-sine[k] * rest[k]);
    rest[k] *= cosine[k];
    h.push_back(std::move(column));
    ++out.iterations;
    out.reduction = std::abs(rest[k + 1]) / norm;
    if (out.reduction <= tolerance || next == 0.0) break;
    for (double& x : w) x /= next;
    v.push_back(std::move(w));
  }
  std::vector<double> y(out.iterations);
  for (int i = out.iterations - 1; i >= 0; --i) {
    y[i] = rest[i];
    for (int c = i + 1; c < out.iterations; ++c) y[i] -= h[c][i] * y[c];
    y[i] /= h[i][i];
    add(out.x, y[i], v[i]);
  }
  return out;
}

}  // namespace shellback::bearing
