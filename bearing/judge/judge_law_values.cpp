#include "bearing/judge/judge_parts.hpp"
#include "bearing/judge/value_check.hpp"

namespace shellback::bearing {
namespace {

using namespace rheology;

void judge(const ConstantViscosity& l, const ValueCheck& law) {
  law.number("eta", l.eta, "mPa s", kPositive);
}
void judge(const Vogel& l, const ValueCheck& law) {
  law.number("A", l.A, "mPa s", kPositive);
  law.number("B", l.B, "K", kPositive);
  law.number("C", l.C, "K", kPositive);
}
void judge(const ReynoldsSlope& l, const ValueCheck& law) {
  law.number("eta", l.eta, "mPa s", kPositive);
  law.temperature("at", l.at);
  law.number("beta", l.beta, "1/K", kNotNegative);
}

void judge(const Walther& l, const ValueCheck& law) {
  law.number("a", l.a, "");
  law.number("B", l.B, "", kPositive);
  law.number("rho", l.rho, "kg/m3", kPositive);
  law.number("expansivity", l.expansivity, "1/K", kNotNegative);
}

void judge(const NoPressureEffect&, const ValueCheck&) {}
void judge(const Barus& l, const ValueCheck& law) {
  law.number("alpha", l.alpha, "1/Pa", kPositive);
}
void judge(const Roelands& l, const ValueCheck& law) { law.number("Z", l.Z, "", kPositive); }
void judge(const Houpert& l, const ValueCheck& law) {
  law.number("Z", l.Z, "", kPositive);
  law.number("beta", l.beta, "1/K", kPositive);
  law.temperature("at", l.at);
}

void judge(const NoShearThinning&, const ValueCheck&) {}
void judge(const Cross& l, const ValueCheck& law) {
  law.number("r", l.r, "", kUpToOne);
  law.number("K", l.K, "s", kPositive);
  law.number("m", l.m, "", kPositive);
}

void judge(const ConstantDensity& l, const ValueCheck& law) {
  law.number("rho", l.rho, "kg/m3", kPositive);
}
void judge(const DowsonHigginson& l, const ValueCheck& law) {
  law.number("rho0", l.rho0, "kg/m3", kPositive);
  law.temperature("at", l.at);
  law.number("expansivity", l.expansivity, "1/K", kNotNegative);
  law.number("rise", l.rise, "1/Pa", kPositive);
  law.number("limit", l.limit, "1/Pa", kPositive);
}

void judge(const ConstantConductivity& l, const ValueCheck& law) {
  law.number("k", l.k, "W/(m K)", kPositive);
}
void judge(const PressureConductivity& l, const ValueCheck& law) {
  law.number("a", l.a, "W/(m K)", kPositive);
  law.number("b", l.b, "1/GPa", kNotNegative);
  law.number("c", l.c, "1/GPa", kNotNegative);
}
void judge(const TemperatureConductivity& l, const ValueCheck& law) {
  law.number("a", l.a, "W/(m K)", kPositive);
  law.number("b", l.b, "1/K");
  law.number("s", l.s, "", kPositive);
}

void judge(const ConstantHeatCapacity& l, const ValueCheck& law) {
  law.number("cp", l.cp, "J/(kg K)", kPositive);
}
void judge(const TemperatureHeatCapacity& l, const ValueCheck& law) {
  law.number("a", l.a, "J/(kg K)", kPositive);
  law.number("b", l.b, "J/(kg K2)");
  law.number("s", l.s, "", kPositive);
  law.number("n", l.n, "");
}

template <class Law>
void judge_law(const Law& law, const char* key, Findings& to) {
  const ValueCheck check(key, to);
  std::visit([&](const auto& l) { judge(l, check); }, law);
}

void judge_range(const ValidityRange& range, Findings& to) {
  const ValueCheck valid("oil.valid", to);
  if (!(range.T_min < range.T_max)) {
    valid.refuse("temperature", "the first temperature must be the lower one");
  }
  valid.number("pressure", range.p_max, "MPa", kPositive);
  valid.number("shear_rate", range.rate_max, "1/s", kPositive);
}

}  // namespace

void judge_law_values(const Oil& oil, Findings& to) {
  judge_law(oil.temperature, "oil.viscosity.temperature", to);
  judge_law(oil.pressure, "oil.viscosity.pressure", to);
  judge_law(oil.shear, "oil.viscosity.shear", to);
  judge_law(oil.density, "oil.density", to);
  judge_law(oil.conductivity, "oil.conductivity", to);
  judge_law(oil.heat_capacity, "oil.heat_capacity", to);
  judge_range(oil.range, to);
}

}  // namespace shellback::bearing
