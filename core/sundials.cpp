#include "core/sundials.hpp"

#include "core/eigen.hpp"

namespace shellback::sundials {
namespace {

using Numbers = Eigen::Map<Eigen::VectorXd>;

Numbers numbers(N_Vector x) { return {N_VGetArrayPointer(x), N_VGetLength(x)}; }

double dot(N_Vector a, N_Vector b) { return numbers(a).dot(numbers(b)); }
void scale(double c, N_Vector x, N_Vector z) { numbers(z) = c * numbers(x); }
void linear_sum(double a, N_Vector x, double b, N_Vector y, N_Vector z) {
  numbers(z) = a * numbers(x) + b * numbers(y);
}
int linear_combination(int n, double* c, N_Vector* x, N_Vector z) {
  Numbers sum = numbers(z);  // it may be the first of x, and no other
  sum = c[0] * numbers(x[0]);
  for (int k = 1; k < n; ++k) sum += c[k] * numbers(x[k]);
  return 0;
}

}  // namespace

void work_in_lanes(N_Vector x) {
  x->ops->nvdotprod = dot;
  x->ops->nvscale = scale;
  x->ops->nvlinearsum = linear_sum;
  x->ops->nvlinearcombination = linear_combination;
}

}  // namespace shellback::sundials
