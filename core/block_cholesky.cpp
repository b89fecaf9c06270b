#include "core/block_cholesky.hpp"

namespace shellback {

bool factorise(BlockTridiagonal& matrix) {
  const int blocks = static_cast<int>(matrix.diagonal.size());
  for (int k = 0; k < blocks; ++k) {
    Eigen::MatrixXd& d = matrix.diagonal[k];
    if (d.rows() > 0) {
      const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> llt(d);  // in place
      if (llt.info() != Eigen::Success) return false;
    }
    if (k + 1 == blocks) break;
    Eigen::MatrixXd& w = matrix.coupling[k];
    if (w.size() == 0) continue;
    d.triangularView<Eigen::Lower>().transpose().solveInPlace<Eigen::OnTheRight>(w);
    const auto head = w.rows();
    matrix.diagonal[k + 1]
        .topLeftCorner(head, head)
        .selfadjointView<Eigen::Lower>()
        .rankUpdate(w, -1.0);
  }
  return true;
}

void solve_lower(const BlockTridiagonal& factor, BlockColumns& y, int first) {
  const int blocks = static_cast<int>(factor.diagonal.size());
  for (int k = first; k < blocks; ++k) {
    if (factor.diagonal[k].rows() == 0) continue;
    factor.diagonal[k].triangularView<Eigen::Lower>().solveInPlace(y[k]);
    if (k + 1 == blocks) break;
    const Eigen::MatrixXd& w = factor.coupling[k];
    y[k + 1].topRows(w.rows()).noalias() -= w * y[k];
  }
}

void solve_upper(const BlockTridiagonal& factor, BlockColumns& x, int last) {
  if (last < 0) last = static_cast<int>(factor.diagonal.size()) - 1;
  for (int k = last; k >= 0; --k) {
    if (factor.diagonal[k].rows() == 0) continue;
    if (k < last) {
      const Eigen::MatrixXd& w = factor.coupling[k];
      x[k].noalias() -= w.transpose() * x[k + 1].topRows(w.rows());
    }
    factor.diagonal[k].triangularView<Eigen::Lower>().transpose().solveInPlace(x[k]);
  }
}

}  // namespace shellback
