#include "solver/dem/contact_reference.hpp"

#include <cvode/cvode.h>
#include <fmt/core.h>
#include <nvector/nvector_serial.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace slfb::dem {
namespace {

/// Both laws at one contact as one family with p = 0 (linear) or 1/4 (Hertz-Mindlin):
/// F_n = δ^p N, N = k δ^{1+p} + γ v_n, and k_t ξ + c_t v_t = δ^p Θ, Θ = κ δ^p ξ + γ_t v_t.
///
/// N and Θ decide on tension and sliding: unlike the forces they have no common zero of δ^p at the ends of a contact.
struct PairLaw {
  double exponent = 0.0;                           ///< p
  double spring = 0.0, dashpot = 0.0;              ///< k, γ
  double shear_spring = 0.0, shear_dashpot = 0.0;  ///< κ, γ_t

  PairLaw() = default;
  PairLaw(const ReferenceLaw& law, double effective_mass, double effective_radius) {
    if (!(law.restitution > 0.0 && law.restitution <= 1.0) || !(effective_mass > 0.0) || !(effective_radius > 0.0))
      throw std::invalid_argument("reference contact: restitution outside (0, 1], or mass or radius not positive");
    const double log_e = std::log(law.restitution);
    const double beta = -log_e / std::hypot(std::numbers::pi, log_e);
    if (law.kind == ReferenceLaw::Kind::linear) {
      spring = law.stiffness;
      dashpot = 2.0 * beta * std::sqrt(law.stiffness * effective_mass);
      shear_spring = law.tangential_stiffness;
      shear_dashpot = law.tangential_damping;
    } else {
      const double root_radius = std::sqrt(effective_radius);
      const double factor = 2.0 * std::sqrt(5.0 / 6.0) * beta;
      exponent = 0.25;
      spring = 4.0 / 3.0 * law.modulus * root_radius;
      dashpot = factor * std::sqrt(2.0 * law.modulus * root_radius * effective_mass);
      shear_spring = 8.0 * law.shear_modulus * root_radius;
      shear_dashpot = law.mindlin_damping * factor * std::sqrt(shear_spring * effective_mass);
    }
    if (!(spring > 0.0)) throw std::invalid_argument("reference contact: the normal spring has no stiffness");
  }

  /// δ^q. Steps end beyond δ = 0 before the event is located: the linear law simply goes on there, the other has no
  /// continuation but 0.
  [[nodiscard]] double power(double overlap, double q) const {
    return std::pow(exponent > 0.0 ? std::max(overlap, 0.0) : overlap, q);
  }
  [[nodiscard]] double reduced_force(double overlap, double approach) const {
    return spring * power(overlap, 1.0 + exponent) + dashpot * approach;
  }
  [[nodiscard]] double force(double overlap, double approach) const {
    return power(overlap, exponent) * reduced_force(overlap, approach);
  }
  /// Largest overlap of an elastic impact, from k δ^{2+2p}/(2 + 2p) = m v²/2 [m].
  [[nodiscard]] double overlap_scale(double effective_mass, double speed) const {
    return std::pow((1.0 + exponent) * effective_mass * speed * speed / spring, 0.5 / (1.0 + exponent));
  }
  /// Its inverse [m/s].
  [[nodiscard]] double speed_scale(double effective_mass, double overlap) const {
    return std::sqrt(spring * std::pow(overlap, 2.0 + 2.0 * exponent) / ((1.0 + exponent) * effective_mass));
  }
};

void check(int flag, const char* what) {
  if (flag < 0) throw std::runtime_error(fmt::format("reference contact: {} failed with CVODE flag {}", what, flag));
}

/// CVODE with event location. Each phase between events runs in its own time from 0, so that short contacts late in a
/// long history keep their resolution. All events are falling zeros of the root functions.
class Solver {
 public:
  using Function = std::function<void(const double* state, double* result)>;

  Solver(const std::vector<double>& initial, const std::vector<double>& scale, int roots, Function rates,
         Function events)
      : rates_(std::move(rates)), events_(std::move(events)), crossed_(static_cast<std::size_t>(roots)) {
    SUNContext context = nullptr;
    check(SUNContext_Create(nullptr, &context), "SUNContext_Create");
    context_.reset(context);
    state_.reset(N_VNew_Serial(static_cast<sunindextype>(initial.size()), context));
    tolerance_.reset(N_VClone(state_.get()));
    std::copy(initial.begin(), initial.end(), state());
    std::transform(scale.begin(), scale.end(), N_VGetArrayPointer(tolerance_.get()),
                   [](double s) { return 1e-13 * s; });
    // Smooth between the events and not stiff: Adams, with fixed-point iteration.
    memory_.reset(CVodeCreate(CV_ADAMS, context));
    iteration_.reset(SUNNonlinSol_FixedPoint(state_.get(), 0, context));
    const auto rate = [](realtype, N_Vector y, N_Vector f, void* self) {
      static_cast<Solver*>(self)->rates_(N_VGetArrayPointer(y), N_VGetArrayPointer(f));
      return 0;
    };
    const auto root = [](realtype, N_Vector y, realtype* g, void* self) {
      static_cast<Solver*>(self)->events_(N_VGetArrayPointer(y), g);
      return 0;
    };
    void* const memory = memory_.get();
    check(CVodeInit(memory, rate, 0.0, state_.get()), "CVodeInit");
    // The relative part only keeps the demand above rounding for gaps much longer than an overlap.
    check(CVodeSVtolerances(memory, 1e-14, tolerance_.get()), "CVodeSVtolerances");
    check(CVodeSetUserData(memory, this), "CVodeSetUserData");
    check(CVodeSetNonlinearSolver(memory, iteration_.get()), "CVodeSetNonlinearSolver");
    check(CVodeSetMaxNumSteps(memory, 1000000), "CVodeSetMaxNumSteps");
    check(CVodeRootInit(memory, roots, root), "CVodeRootInit");
    std::vector<int> falling(crossed_.size(), -1);
    check(CVodeSetRootDirection(memory, falling.data()), "CVodeSetRootDirection");
    check(CVodeSetNoInactiveRootWarn(memory), "CVodeSetNoInactiveRootWarn");
  }
  Solver(const Solver&) = delete;  // CVODE holds a pointer to this
  Solver& operator=(const Solver&) = delete;

  /// Events that come and go within a step are missed [s]; 0: no limit.
  void limit_step(double longest) { check(CVodeSetMaxStep(memory_.get(), longest), "CVodeSetMaxStep"); }
  [[nodiscard]] double* state() { return N_VGetArrayPointer(state_.get()); }
  [[nodiscard]] double time() const { return start_ + elapsed_; }
  [[nodiscard]] bool crossed(std::size_t root) const { return crossed_[root] != 0; }

  /// Runs through `times`, calling on_event at the events (it may change the state and what the functions do) and
  /// on_sample at the times.
  template <class OnEvent, class OnSample>
  void run(const std::vector<double>& times, const OnEvent& on_event, const OnSample& on_sample) {
    if (!std::is_sorted(times.begin(), times.end()) || (!times.empty() && !(times.front() >= 0.0)))
      throw std::invalid_argument("reference contact: output times must ascend from 0 on");
    constexpr int most_events = 100000;
    int events = 0;
    for (double target : times) {
      while (time() < target) {
        const int flag = CVode(memory_.get(), target - start_, state_.get(), &elapsed_, CV_NORMAL);
        check(flag, "CVode");
        if (flag != CV_ROOT_RETURN) break;
        if (++events > most_events) throw std::runtime_error("reference contact: events without end");
        check(CVodeGetRootInfo(memory_.get(), crossed_.data()), "CVodeGetRootInfo");
        on_event();
        start_ += elapsed_;
        elapsed_ = 0.0;
        check(CVodeReInit(memory_.get(), 0.0, state_.get()), "CVodeReInit");
      }
      on_sample(target);
    }
  }

 private:
  template <auto Free>
  struct Deleter {
    template <class T>
    void operator()(T* pointer) const {
      if constexpr (std::is_invocable_v<decltype(Free), T*>)
        Free(pointer);
      else
        Free(&pointer);
    }
  };
  Function rates_, events_;
  std::vector<int> crossed_;
  double start_ = 0.0, elapsed_ = 0.0;
  // In the order of creation: the context goes last.
  std::unique_ptr<std::remove_pointer_t<SUNContext>, Deleter<&SUNContext_Free>> context_;
  std::unique_ptr<std::remove_pointer_t<N_Vector>, Deleter<&N_VDestroy>> state_, tolerance_;
  std::unique_ptr<std::remove_pointer_t<SUNNonlinearSolver>, Deleter<&SUNNonlinSolFree>> iteration_;
  std::unique_ptr<void, Deleter<&CVodeFree>> memory_;
};

double sign(double value) { return value < 0.0 ? -1.0 : 1.0; }

/// The gaps are the variables, not the positions: an overlap of 1e-6 m at 1 m would otherwise lose ten digits.
/// State: N + 1 gaps, N velocities.
class LineMotion {
 public:
  explicit LineMotion(const ReferenceLine& line) : line_(line), count_(line.spheres.size()) {
    if (count_ == 0) throw std::invalid_argument("reference contact: a line without spheres");
    const auto& spheres = line.spheres;
    double energy = 0.0;  // per mass, twice: sets the scale of the speeds
    for (std::size_t k = 0; k <= count_; ++k) {
      const bool lower = k == 0, upper = k == count_;
      double gap = 0.0, mass = 0.0;
      if (lower || upper) {
        const ReferenceSphere& sphere = lower ? spheres.front() : spheres.back();
        const std::optional<double>& wall = lower ? line.lower_wall : line.upper_wall;
        mass = sphere.mass;
        if (wall) gap = (lower ? sphere.position - *wall : *wall - sphere.position) - sphere.radius;
        laws_.emplace_back(line.law, mass, sphere.radius);
        modes_.push_back(wall ? Mode::open : Mode::absent);
      } else {
        const ReferenceSphere &a = spheres[k - 1], &b = spheres[k];
        mass = a.mass * b.mass / (a.mass + b.mass);
        gap = b.position - a.position - a.radius - b.radius;
        laws_.emplace_back(line.law, mass, a.radius * b.radius / (a.radius + b.radius));
        modes_.push_back(Mode::open);
      }
      // Touching to the rounding of the positions is touching.
      if (std::abs(gap) < 1e-12 * spheres[std::min(k, count_ - 1)].radius) gap = 0.0;
      masses_.push_back(mass);
      initial_.push_back(gap);
      const double resting = std::pow(mass * line.gravity / laws_[k].spring, 1.0 / (1.0 + 2.0 * laws_[k].exponent));
      const double speed = laws_[k].speed_scale(mass, std::max(-gap, resting));
      energy += speed * speed + 2.0 * line.gravity * std::max(gap, 0.0);
    }
    for (const ReferenceSphere& sphere : spheres) {
      initial_.push_back(sphere.velocity);
      energy += sphere.velocity * sphere.velocity;
    }
    if (!(energy > 0.0) || !std::isfinite(energy))
      throw std::invalid_argument("reference contact: nothing moves on the line, or a value is not finite");
    for (std::size_t k = 0; k <= count_; ++k) {
      scale_.push_back(laws_[k].overlap_scale(masses_[k], std::sqrt(energy)));
      const double rate = gap_rate(initial_.data(), k);
      if (exists(k) && (initial_[k] < 0.0 || (initial_[k] == 0.0 && rate <= 0.0))) close(initial_.data(), k);
    }
    scale_.resize(2 * count_ + 1, std::sqrt(energy));
  }

  ReferenceTrajectory<ReferenceLineState> follow(const std::vector<double>& times) {
    ReferenceTrajectory<ReferenceLineState> trajectory;
    Solver solver(
        initial_, scale_, 2 * static_cast<int>(count_ + 1), [this](const double* y, double* f) { rates(y, f); },
        [this](const double* y, double* g) { events(y, g); });
    // An upper wall, from which gravity pulls away, could be touched and left within one step of a free flight.
    if (!times.empty()) solver.limit_step(times.back() / 200.0);
    solver.run(
        times,
        [&] {
          for (std::size_t k = 0; k <= count_; ++k) {
            const auto note = [&](ReferenceEventKind kind) {
              trajectory.events.push_back({kind, static_cast<int>(k), snapshot(solver.state(), solver.time())});
            };
            if (solver.crossed(2 * k)) {
              const bool starts = modes_[k] == Mode::open;
              note(starts ? ReferenceEventKind::contact_start : ReferenceEventKind::contact_end);
              if (starts)
                close(solver.state(), k);
              else
                modes_[k] = Mode::open;
            } else if (solver.crossed(2 * k + 1)) {
              const bool starts = modes_[k] == Mode::pushing;
              note(starts ? ReferenceEventKind::tension_start : ReferenceEventKind::tension_end);
              modes_[k] = starts ? Mode::cut : Mode::pushing;
            }
          }
        },
        [&](double time) { trajectory.samples.push_back(snapshot(solver.state(), time)); });
    return trajectory;
  }

 private:
  enum class Mode { absent, open, pushing, cut };

  [[nodiscard]] bool exists(std::size_t k) const { return modes_[k] != Mode::absent; }
  [[nodiscard]] double gap_rate(const double* y, std::size_t k) const {
    const double* velocity = y + count_ + 1;
    return (k < count_ ? velocity[k] : 0.0) - (k > 0 ? velocity[k - 1] : 0.0);
  }
  [[nodiscard]] double reduced_force(const double* y, std::size_t k) const {
    return laws_[k].reduced_force(-y[k], -gap_rate(y, k));
  }
  void close(const double* y, std::size_t k) {
    modes_[k] = line_.law.cut_tension && reduced_force(y, k) < 0.0 ? Mode::cut : Mode::pushing;
  }

  void rates(const double* y, double* f) const {
    double* acceleration = f + count_ + 1;
    std::fill_n(acceleration, count_, -line_.gravity);
    for (std::size_t k = 0; k <= count_; ++k) {
      f[k] = gap_rate(y, k);
      if (modes_[k] != Mode::pushing) continue;
      const double force = laws_[k].force(-y[k], -f[k]);
      if (k < count_) acceleration[k] += force / line_.spheres[k].mass;
      if (k > 0) acceleration[k - 1] -= force / line_.spheres[k - 1].mass;
    }
  }

  void events(const double* y, double* g) const {
    for (std::size_t k = 0; k <= count_; ++k) {
      const Mode mode = modes_[k];
      g[2 * k] = mode == Mode::absent ? 1.0 : mode == Mode::open ? y[k] : -y[k];
      g[2 * k + 1] = mode == Mode::cut                                ? -reduced_force(y, k)
                     : mode == Mode::pushing && line_.law.cut_tension ? reduced_force(y, k)
                                                                      : 1.0;
    }
  }

  [[nodiscard]] ReferenceLineState snapshot(const double* y, double time) const {
    ReferenceLineState state{time, {}, {y + count_ + 1, y + 2 * count_ + 1}, {y, y + count_ + 1}};
    const auto& spheres = line_.spheres;
    double position = line_.lower_wall ? *line_.lower_wall + spheres.front().radius : spheres.front().position;
    for (std::size_t k = 0; k <= count_; ++k) {
      if (k < count_) {
        if (k > 0) position += spheres[k - 1].radius + spheres[k].radius;
        state.position.push_back(position += y[k]);
      }
      const double violation = modes_[k] == Mode::open ? -y[k] : y[k];
      if (exists(k) && violation > 1e-6 * scale_[k])
        throw std::runtime_error(fmt::format("reference contact: event of contact {} missed before t = {} s", k, time));
      if (!exists(k)) state.gap[k] = 0.0;
    }
    return state;
  }

  const ReferenceLine& line_;
  std::size_t count_;
  std::vector<PairLaw> laws_;
  std::vector<double> masses_;  ///< effective, of each contact
  std::vector<Mode> modes_;
  std::vector<double> initial_, scale_;
};

/// State: gap, v_z, x, v_x, ω, ξ (at rest unless the contact sticks).
class ImpactMotion {
 public:
  explicit ImpactMotion(const ReferenceImpact& impact)
      : impact_(impact), law_(impact.law, impact.mass, impact.radius), mass_(impact.mass), radius_(impact.radius) {
    if (!(impact.normal_speed > 0.0)) throw std::invalid_argument("reference contact: the sphere does not approach");
    if (impact.law.friction > 0.0 && !(law_.shear_spring > 0.0))
      throw std::invalid_argument("reference contact: friction without tangential stiffness");
  }

  ReferenceTrajectory<ReferenceImpactState> follow(const std::vector<double>& times) {
    const double speed = impact_.normal_speed, overlap = law_.overlap_scale(mass_, speed);
    ReferenceTrajectory<ReferenceImpactState> trajectory;
    std::vector<double> initial{0.0, -speed, 0.0, impact_.tangential_velocity, impact_.spin, 0.0};
    start(initial.data());
    Solver solver(
        initial, {overlap, speed, overlap, speed, speed / radius_, overlap}, 5,
        [this](const double* y, double* f) { rates(y, f); }, [this](const double* y, double* g) { events(y, g); });
    solver.limit_step(overlap / speed / 100.0);
    const auto note = [&](ReferenceEventKind kind) {
      trajectory.events.push_back({kind, 0, snapshot(solver.state(), solver.time())});
    };
    note(ReferenceEventKind::contact_start);
    note(mode_ == Mode::stick ? ReferenceEventKind::sticking_start : ReferenceEventKind::sliding_start);
    solver.run(
        times,
        [&] {
          double* y = solver.state();
          if (solver.crossed(0)) {
            mode_ = Mode::apart;
            solver.limit_step(0.0);
            note(ReferenceEventKind::contact_end);
          } else if (solver.crossed(1)) {
            mode_ = Mode::loose;
            note(ReferenceEventKind::tension_start);
          } else if (mode_ == Mode::slide) {
            y[5] = slaved_spring(contact(y));
            mode_ = Mode::stick;
            note(ReferenceEventKind::sticking_start);
          } else {
            direction_ = solver.crossed(2) ? 1.0 : -1.0;
            // Just after sticking_start the limit is equalled to rounding: that is no sliding.
            if (sliding_margin(contact(y)) <= 0.0) return;
            mode_ = Mode::slide;
            note(ReferenceEventKind::sliding_start);
          }
        },
        [&](double time) { trajectory.samples.push_back(snapshot(solver.state(), time)); });
    return trajectory;
  }

 private:
  enum class Mode { stick, slide, loose, apart };  ///< loose: overlapping with F_n < 0

  struct Contact {
    double overlap, approach, slip, spring;
    double factor, reduced;  ///< δ^p, N
  };
  [[nodiscard]] Contact contact(const double* y) const {
    const double overlap = -y[0], approach = -y[1];
    return {overlap,
            approach,
            y[3] - y[4] * radius_,
            y[5],
            law_.power(overlap, law_.exponent),
            law_.reduced_force(overlap, approach)};
  }

  /// Whether the first instant slides: Θ against μ N for δ → 0, where ξ = δ v_t/v_n.
  void start(double* y) {
    const Contact c = contact(y);
    const double friction = impact_.law.friction, slip = std::abs(c.slip);
    const double dashpots = law_.shear_dashpot * slip - friction * law_.dashpot * c.approach;
    const double springs = law_.shear_spring * slip - friction * law_.spring * c.approach;
    mode_ = friction == 0.0 || dashpots > 0.0 || (dashpots == 0.0 && springs > 0.0) ? Mode::slide : Mode::stick;
    // Where k_t grows from 0 and c_t v_t alone exceeds the limit, the slaved spring −(c_t v_t − μ F_n)/k_t pulls
    // against the dashpot and stiffens so fast that the limit is exceeded on the other side at once.
    direction_ = law_.exponent > 0.0 && dashpots > 0.0 ? -sign(c.slip) : sign(c.slip);
    // The dashpot alone is above the limit but its force falls off from there: the spring takes the difference at once,
    // and the contact sticks.
    if (mode_ == Mode::slide && friction > 0.0 && sliding_margin(c) < 0.0) {
      mode_ = Mode::stick;
      y[5] = slaved_spring(c);
    }
  }

  /// d(σ Θ − μ N)/dt, times δ^{4p}, of a sliding contact whose spring were released: positive as long as it slides.
  /// p enters by dk_t/dt, with κ δ^p ξ = σ μ N − γ_t v_t.
  [[nodiscard]] double sliding_margin(const Contact& c) const {
    const double friction = impact_.law.friction, p = law_.exponent;
    const double springs = direction_ * law_.shear_spring * c.slip - friction * law_.spring * c.approach;
    if (law_.dashpot == 0.0 && law_.shear_dashpot == 0.0) return springs;  // a common factor left out
    const double deceleration = c.factor * c.reduced / mass_;
    const double slip_deceleration = 3.5 * direction_ * friction * deceleration;
    return law_.power(c.overlap, 5.0 * p) * springs +
           p * c.approach * (friction * law_.dashpot * c.approach - direction_ * law_.shear_dashpot * c.slip) +
           law_.power(c.overlap, 4.0 * p) *
               (friction * law_.dashpot * deceleration - direction_ * law_.shear_dashpot * slip_deceleration);
  }
  [[nodiscard]] double reduced_shear(const Contact& c) const {
    return law_.shear_spring * c.factor * c.spring + law_.shear_dashpot * c.slip;
  }
  [[nodiscard]] double slaved_spring(const Contact& c) const {
    if (c.factor == 0.0) return 0.0;  // no spring yet, or no more
    return (direction_ * impact_.law.friction * c.reduced - law_.shear_dashpot * c.slip) /
           (law_.shear_spring * c.factor);
  }

  [[nodiscard]] double normal_force(const Contact& c) const {
    const bool none = mode_ == Mode::apart || (mode_ == Mode::loose && impact_.law.cut_tension);
    return none ? 0.0 : c.factor * c.reduced;
  }
  [[nodiscard]] double tangential_force(const Contact& c) const {
    if (mode_ == Mode::stick) return -c.factor * reduced_shear(c);
    return mode_ == Mode::slide ? -direction_ * impact_.law.friction * c.factor * c.reduced : 0.0;
  }

  void rates(const double* y, double* f) const {
    const Contact c = contact(y);
    f[0] = y[1];
    f[1] = normal_force(c) / mass_;
    f[2] = y[3];
    f[3] = tangential_force(c) / mass_;
    f[4] = -tangential_force(c) / (0.4 * mass_ * radius_);
    f[5] = mode_ == Mode::stick ? c.slip : 0.0;
  }

  void events(const double* y, double* g) const {
    const Contact c = contact(y);
    const double limit = impact_.law.friction * c.reduced;
    const bool sticks = mode_ == Mode::stick, slides = mode_ == Mode::slide;
    g[0] = mode_ == Mode::apart ? 1.0 : c.overlap;
    g[1] = sticks || slides ? c.reduced : 1.0;
    g[2] = sticks ? limit - reduced_shear(c) : 1.0;
    g[3] = sticks ? limit + reduced_shear(c) : 1.0;
    g[4] = slides && impact_.law.friction > 0.0 ? sliding_margin(c) : 1.0;
  }

  [[nodiscard]] ReferenceImpactState snapshot(const double* y, double time) const {
    const Contact c = contact(y);
    const bool sticks = mode_ == Mode::stick, slides = mode_ == Mode::slide && impact_.law.friction > 0.0;
    return {time,
            y[2],
            radius_ + y[0],
            y[3],
            y[1],
            y[4],
            c.overlap,
            sticks   ? c.spring
            : slides ? slaved_spring(c)
                     : 0.0,
            normal_force(c),
            tangential_force(c)};
  }

  const ReferenceImpact& impact_;
  PairLaw law_;
  double mass_, radius_;
  Mode mode_ = Mode::stick;
  double direction_ = 1.0;  ///< σ, of k_t ξ + c_t v_t when sliding
};

}  // namespace

ReferenceTrajectory<ReferenceLineState> reference_line(const ReferenceLine& line, const std::vector<double>& times) {
  return LineMotion(line).follow(times);
}

ReferenceTrajectory<ReferenceImpactState> reference_impact(const ReferenceImpact& impact,
                                                           const std::vector<double>& times) {
  return ImpactMotion(impact).follow(times);
}

ReferenceTrajectory<ReferenceLineState> reference_bounce(const ReferenceLaw& law, double radius, double mass,
                                                         double gravity, double height,
                                                         const std::vector<double>& times) {
  ReferenceLine line;
  line.law = law;
  line.spheres = {{radius, mass, height, 0.0}};
  line.gravity = gravity;
  line.lower_wall = 0.0;
  return reference_line(line, times);
}

}  // namespace slfb::dem
