// SPDX-License-Identifier: MIT
#include "support/exact_checker.hpp"

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstddef>
#include <variant>
#include <vector>

namespace tutavia::test {

class ExactChecker::Judge {
 public:
  explicit Judge(const Workspace& world) : world_(world), r_(world.safety_radius) {
    for (const Obstacle& obstacle : world.obstacles) {
      if (const Disc* disc = std::get_if<Disc>(&obstacle)) {
        parts_.push_back({disc->center, disc->center, disc->radius});
        continue;
      }
      const Polygon& polygon = std::get<Polygon>(obstacle);
      add(polygon.outer);
      for (const Ring& hole : polygon.holes) add(hole);
    }
  }

  ExactVerdict check(const Curve& curve) const {
    ExactVerdict verdict = curve.empty() ? ExactVerdict::unknown : ExactVerdict::free;
    for (const Piece& piece : curve.pieces()) {
      verdict = worse(verdict, check(piece));
      if (verdict == ExactVerdict::blocked) break;
    }
    return verdict;
  }

  ExactVerdict check(const Piece& piece) const {
    return piece.visit([&](const auto& p) { return check_piece(p); });
  }

 private:
  using Q = boost::multiprecision::cpp_rational;
  using F = boost::multiprecision::cpp_bin_float_100;

  /// An obstacle edge, or a disc around a single point.
  struct Part {
    Point a, b;
    double radius;
  };
  struct Vector {
    Q x, y;
  };
  using Polynomial = std::vector<Q>;  // Bernstein coefficients on [0, 1]

  static ExactVerdict worse(ExactVerdict a, ExactVerdict b) {
    if (a == ExactVerdict::blocked || b == ExactVerdict::blocked) return ExactVerdict::blocked;
    return a == ExactVerdict::free ? b : a;
  }
  static Vector exact(const Point& p) { return {Q(p.x()), Q(p.y())}; }
  static Vector minus(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y}; }
  static Q dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y; }
  static Q det(const Vector& a, const Vector& b) { return a.x * b.y - a.y * b.x; }

  void add(const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      parts_.push_back({ring[i], ring[(i + 1) % ring.size()], 0});
    }
  }

  /// Whether boxes prove that a piece within `box` keeps clear of a part, with a wide margin.
  bool is_far(const Part& part, const Box& box) const {
    const double reach = (part.radius + r_) * (1 + 1e-9) + 1e-9 * (1 + box.largest_coordinate());
    return std::max(part.a.x(), part.b.x()) + reach < box.min.x() ||
           std::min(part.a.x(), part.b.x()) - reach > box.max.x() ||
           std::max(part.a.y(), part.b.y()) + reach < box.min.y() ||
           std::min(part.a.y(), part.b.y()) - reach > box.max.y();
  }

  bool in_bounds(const Point& p) const {
    return world_.bounds.min.x() <= p.x() && p.x() <= world_.bounds.max.x() &&
           world_.bounds.min.y() <= p.y() && p.y() <= world_.bounds.max.y();
  }

  /// Turns of a ring around an exact point off its edges, and whether the point is on an edge.
  static int turns(const Ring& ring, const Vector& p, bool& on_edge) {
    int number = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vector a = minus(exact(ring[i]), p), b = minus(exact(ring[(i + 1) % ring.size()]), p);
      const Q side = det(a, b);
      if (side == 0 && dot(a, b) <= 0) on_edge = true;
      if (a.y <= 0 && b.y > 0 && side > 0) ++number;
      if (a.y > 0 && b.y <= 0 && side < 0) --number;
    }
    return number;
  }

  /// Whether the open interior of some polygon contains the point.
  bool is_inside_some_polygon(const Vector& p) const {
    for (const Obstacle& obstacle : world_.obstacles) {
      const Polygon* polygon = std::get_if<Polygon>(&obstacle);
      if (polygon == nullptr) continue;
      bool on_edge = false;
      bool inside = turns(polygon->outer, p, on_edge) != 0;
      for (const Ring& hole : polygon->holes) {
        if (turns(hole, p, on_edge) % 2 != 0) inside = false;
      }
      if (inside && !on_edge) return true;
    }
    return false;
  }

  static Q square_distance(const Vector& p, const Vector& a, const Vector& b) {
    const Vector ab = minus(b, a), ap = minus(p, a), bp = minus(p, b);
    const Q length = dot(ab, ab), along = dot(ap, ab);
    if (along <= 0) return dot(ap, ap);
    if (along >= length) return dot(bp, bp);
    const Q area = det(ab, ap);
    return area * area / length;
  }

  static int sign(const Q& q) { return q > 0 ? 1 : q < 0 ? -1 : 0; }

  static bool meet(const Vector& p, const Vector& q, const Vector& a, const Vector& b) {
    const Q zero = 0;
    return square_distance(p, a, b) == zero || square_distance(q, a, b) == zero ||
           square_distance(a, p, q) == zero || square_distance(b, p, q) == zero ||
           (sign(det(minus(q, p), minus(a, p))) * sign(det(minus(q, p), minus(b, p))) < 0 &&
            sign(det(minus(b, a), minus(p, a))) * sign(det(minus(b, a), minus(q, a))) < 0);
  }

  Q limit(const Part& part) const {
    const Q sum = Q(part.radius) + Q(r_);
    return sum * sum;
  }

  ExactVerdict check_piece(const Segment& s) const {
    if (!in_bounds(s.a) || !in_bounds(s.b)) return ExactVerdict::blocked;
    const Vector p = exact(s.a), q = exact(s.b);
    if (r_ == 0) return check_contact(s, p, q);
    for (const Part& part : parts_) {
      if (is_far(part, Box::around({s.a, s.b}))) continue;
      const Vector a = exact(part.a), b = exact(part.b);
      const Q least = limit(part);
      if (meet(p, q, a, b) || square_distance(p, a, b) < least ||
          square_distance(q, a, b) < least || square_distance(a, p, q) < least ||
          square_distance(b, p, q) < least) {
        return ExactVerdict::blocked;
      }
    }
    return is_inside_some_polygon(p) ? ExactVerdict::blocked : ExactVerdict::free;
  }

  /// Safety radius 0: no point of the segment is inside a polygon or a disc. The segment is cut
  /// where it meets edges, and one point of every part is tested.
  ExactVerdict check_contact(const Segment& s, const Vector& p, const Vector& q) const {
    std::vector<Q> cuts{0, 1};
    const Vector d = minus(q, p);
    for (const Part& part : parts_) {
      if (is_far(part, Box::around({s.a, s.b}))) continue;
      const Vector a = exact(part.a), b = exact(part.b);
      if (part.radius > 0 && square_distance(a, p, q) < limit(part)) return ExactVerdict::blocked;
      const Vector e = minus(b, a);
      const Q denominator = det(d, e), length = dot(d, d);
      if (denominator != 0) {
        cuts.push_back(det(minus(a, p), e) / denominator);
      } else if (length != 0) {
        cuts.push_back(dot(minus(a, p), d) / length);
        cuts.push_back(dot(minus(b, p), d) / length);
      }
    }
    std::erase_if(cuts, [](const Q& t) { return t < 0 || t > 1; });
    std::sort(cuts.begin(), cuts.end());
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
    for (std::size_t i = 0; i < cuts.size(); ++i) {
      const Q t = i + 1 < cuts.size() ? Q((cuts[i] + cuts[i + 1]) / 2) : cuts[i];
      if (is_inside_some_polygon({p.x + t * d.x, p.y + t * d.y})) return ExactVerdict::blocked;
    }
    return ExactVerdict::free;
  }

  static Polynomial product(const Polynomial& f, const Polynomial& g) {
    const auto choose = [](std::size_t n, std::size_t k) {
      Q result = 1;
      for (std::size_t i = 1; i <= k; ++i) result = result * Q(n - k + i) / Q(i);
      return result;
    };
    const std::size_t n = f.size() - 1, m = g.size() - 1;
    Polynomial result(n + m + 1, Q(0));
    for (std::size_t i = 0; i <= n; ++i) {
      for (std::size_t j = 0; j <= m; ++j) {
        result[i + j] += choose(n, i) * choose(m, j) / choose(n + m, i + j) * f[i] * g[j];
      }
    }
    return result;
  }
  static Polynomial sum(Polynomial f, const Polynomial& g) {
    for (std::size_t i = 0; i < f.size(); ++i) f[i] += g[i];
    return f;
  }
  static Polynomial shifted(Polynomial f, const Q& c) {
    for (Q& value : f) value += c;
    return f;
  }
  static bool all(const Polynomial& f, int wanted, bool strict) {
    return std::all_of(f.begin(), f.end(), [&](const Q& value) {
      return strict ? sign(value) == wanted : sign(value) * wanted >= 0;
    });
  }
  static void halve(Polynomial f, Polynomial& left, Polynomial& right) {
    const std::size_t n = f.size();
    left.resize(n);
    right.resize(n);
    for (std::size_t level = 0; level < n; ++level) {
      left[level] = f[0];
      right[n - 1 - level] = f[n - 1 - level];
      for (std::size_t i = 0; i + 1 < n - level; ++i) f[i] = (f[i] + f[i + 1]) / 2;
    }
  }

  template <std::size_t Degree>
  ExactVerdict check_piece(const Bezier<Degree>& bezier) const {
    if (!in_bounds(bezier.points.front()) || !in_bounds(bezier.points.back())) {
      return ExactVerdict::blocked;
    }
    Polynomial x, y;
    Box box;
    for (const Point& p : bezier.points) {
      x.push_back(Q(p.x()));
      y.push_back(Q(p.y()));
      box.include(p);
    }
    ExactVerdict verdict = ExactVerdict::free;
    const Box& b = world_.bounds;
    if (!b.contains(box)) {
      verdict = worse(verdict, never_negative(shifted(x, -Q(b.min.x()))));
      verdict = worse(verdict, never_negative(shifted(y, -Q(b.min.y()))));
      verdict = worse(verdict, never_negative(shifted(negative(x), Q(b.max.x()))));
      verdict = worse(verdict, never_negative(shifted(negative(y), Q(b.max.y()))));
    }
    for (const Part& part : parts_) {
      if (verdict == ExactVerdict::blocked) return verdict;
      if (!is_far(part, box)) verdict = worse(verdict, keeps(x, y, part, 0));
    }
    if (is_inside_some_polygon(exact(bezier.points.front()))) return ExactVerdict::blocked;
    return verdict;
  }

  static Polynomial negative(Polynomial f) {
    for (Q& value : f) value = -value;
    return f;
  }

  static ExactVerdict never_negative(const Polynomial& f, int depth = 0) {
    if (all(f, 1, false)) return ExactVerdict::free;
    if (f.front() < 0 || f.back() < 0) return ExactVerdict::blocked;
    if (depth == max_depth) return ExactVerdict::unknown;
    Polynomial left, right;
    halve(f, left, right);
    return worse(never_negative(left, depth + 1), never_negative(right, depth + 1));
  }

  /// Whether the Bezier piece (x, y) keeps its distance from one part.
  ExactVerdict keeps(const Polynomial& x, const Polynomial& y, const Part& part, int depth) const {
    const Vector a = exact(part.a), b = exact(part.b), ab = minus(b, a);
    const Q least = limit(part), length = dot(ab, ab);
    for (const std::size_t end : {std::size_t{0}, x.size() - 1}) {
      if (square_distance({x[end], y[end]}, a, b) < least) return ExactVerdict::blocked;
    }
    const Polynomial ax = shifted(x, -a.x), ay = shifted(y, -a.y);
    Polynomial along = ax, aside = ax;
    for (std::size_t i = 0; i < ax.size(); ++i) {
      along[i] = ax[i] * ab.x + ay[i] * ab.y;
      aside[i] = ab.x * ay[i] - ab.y * ax[i];
    }
    const bool before = all(along, -1, false), after = all(shifted(along, -length), 1, false);
    const bool contact = r_ == 0 && part.radius == 0;
    bool clear = false;
    if (contact) {  // may not meet at all
      clear = all(aside, 1, true) || all(aside, -1, true) || all(along, -1, true) ||
              all(shifted(along, -length), 1, true);
      if (length == 0)
        clear = all(ax, 1, true) || all(ax, -1, true) || all(ay, 1, true) || all(ay, -1, true);
    } else {
      const auto far_from = [&](const Vector& v) {
        const Polynomial vx = shifted(x, -v.x), vy = shifted(y, -v.y);
        return all(shifted(sum(product(vx, vx), product(vy, vy)), -least), 1, false);
      };
      const auto far_from_line = [&] {
        return length != 0 && all(shifted(product(aside, aside), -least * length), 1, false);
      };
      clear = length == 0 ? far_from(a)
                          : (before && far_from(a)) || (after && far_from(b)) || far_from_line();
    }
    if (clear) return ExactVerdict::free;
    if (depth == max_depth) return ExactVerdict::unknown;
    Polynomial x0, x1, y0, y1;
    halve(x, x0, x1);
    halve(y, y0, y1);
    const ExactVerdict first = keeps(x0, y0, part, depth + 1);
    return first == ExactVerdict::blocked ? first : worse(first, keeps(x1, y1, part, depth + 1));
  }

  /// Arcs by centre, radius and angles, in a hundred digits; anything within 1e-60 of a tie is
  /// unknown. The stored ends may be off the circle by rounding and are checked as points.
  ExactVerdict check_piece(const Arc& arc) const {
    ExactVerdict verdict =
        worse(check_piece(Segment{arc.a, arc.a}), check_piece(Segment{arc.b, arc.b}));
    const F cx = arc.center.x(), cy = arc.center.y(), radius = arc.radius;
    const F from = arc.start_angle, sweep = arc.sweep, pi = boost::math::constants::pi<F>();
    const auto covers = [&](const F& x, const F& y) {
      F turn = atan2(y, x) - from;
      if (sweep < 0) turn = -turn;
      turn -= 2 * pi * floor(turn / (2 * pi));
      return turn <= abs(sweep);
    };
    const auto require = [&](const F& margin) {
      const F tiny("1e-60");
      if (margin < -tiny)
        verdict = ExactVerdict::blocked;
      else if (margin < tiny)
        verdict = worse(verdict, ExactVerdict::unknown);
    };
    const auto require_extreme = [&](int x, int y, const F& margin) {
      if (covers(F(x), F(y))) require(margin);
    };
    require_extreme(1, 0, F(world_.bounds.max.x()) - cx - radius);
    require_extreme(0, 1, F(world_.bounds.max.y()) - cy - radius);
    require_extreme(-1, 0, cx - radius - F(world_.bounds.min.x()));
    require_extreme(0, -1, cy - radius - F(world_.bounds.min.y()));
    for (const Part& part : parts_) {
      const F ax = F(part.a.x()) - cx, ay = F(part.a.y()) - cy;
      const F bx = F(part.b.x()) - cx, by = F(part.b.y()) - cy, least = F(part.radius) + F(r_);
      const F dx = bx - ax, dy = by - ay, length = sqrt(dx * dx + dy * dy);
      const auto to_part = [&](const F& x, const F& y) {
        F t = length > 0 ? F(((x - ax) * dx + (y - ay) * dy) / (length * length)) : F(0);
        t = t < 0 ? F(0) : t > 1 ? F(1) : t;
        const F ex = x - ax - t * dx, ey = y - ay - t * dy;
        return F(sqrt(ex * ex + ey * ey));
      };
      const auto consider = [&](const F& x, const F& y) {  // the arc's point in this direction
        const F norm = sqrt(x * x + y * y);
        if (norm > 0 && covers(x, y))
          require(to_part(radius * x / norm, radius * y / norm) - least);
      };
      require(to_part(radius * cos(from), radius * sin(from)) - least);
      require(to_part(radius * cos(from + sweep), radius * sin(from + sweep)) - least);
      consider(ax, ay);
      consider(bx, by);
      if (length > 0) {
        const F height = (ax * dy - ay * dx) / length, ux = dx / length, uy = dy / length;
        consider(uy, -ux);
        consider(-uy, ux);
        if (abs(height) <= radius) {
          const F half = sqrt(radius * radius - height * height);
          consider(height * uy + half * ux, -height * ux + half * uy);
          consider(height * uy - half * ux, -height * ux - half * uy);
        }
      }
      if (verdict == ExactVerdict::blocked) return verdict;
    }
    return verdict;
  }

  struct Location {
    F x, y;
  };

  /// The point of the clothoid at arc length s, by the power series of its direction: with exp(i (k
  /// s + c s^2 / 2)) = sum a_n s^n, (n + 1) a_(n+1) = i (k a_n + c a_(n-1)).
  static Location location(const Clothoid& clothoid, const F& s) {
    const F k = clothoid.start_curvature, c = clothoid.sharpness;
    F re = 1, im = 0, re_before = 0, im_before = 0;  // a_n s^n and a_(n-1) s^(n-1)
    F x = 0, y = 0;
    const F tiny("1e-80");
    for (int n = 0; n < 2000; ++n) {
      x += re / (n + 1);
      y += im / (n + 1);
      if (n > 4 && abs(re) + abs(im) + abs(re_before) + abs(im_before) < tiny) break;
      const F u = k * s * re + c * s * s * re_before, v = k * s * im + c * s * s * im_before;
      re_before = re, im_before = im;
      re = -v / (n + 1);
      im = u / (n + 1);
    }
    const F heading = clothoid.start_heading, cosine = cos(heading), sine = sin(heading);
    return {F(clothoid.a.x()) + s * (x * cosine - y * sine),
            F(clothoid.a.y()) + s * (x * sine + y * cosine)};
  }

  static F to_segment(const Location& p, const Location& a, const Location& b) {
    const F dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
    F t = square > 0 ? F(((p.x - a.x) * dx + (p.y - a.y) * dy) / square) : F(0);
    t = t < 0 ? F(0) : t > 1 ? F(1) : t;
    const F ex = p.x - a.x - t * dx, ey = p.y - a.y - t * dy;
    return sqrt(ex * ex + ey * ey);
  }
  static F between(const Location& p, const Location& q, const Location& a, const Location& b) {
    const auto side = [](const Location& u, const Location& v, const Location& w) {
      return F((v.x - u.x) * (w.y - u.y) - (v.y - u.y) * (w.x - u.x));
    };
    if (side(p, q, a) * side(p, q, b) < 0 && side(a, b, p) * side(a, b, q) < 0) return 0;
    return std::min(
        {to_segment(p, a, b), to_segment(q, a, b), to_segment(a, p, q), to_segment(b, p, q)});
  }

  /// Clothoids by their parameters, in a hundred digits, by halving: a part of length h is within k
  /// h^2 / 8 of its chord for the largest curvature k. Closer than 1e-30 to a tie is unknown. The
  /// stored end is checked as a point.
  ExactVerdict check_piece(const Clothoid& clothoid) const {
    ExactVerdict verdict = worse(check_piece(Segment{clothoid.a, clothoid.a}),
                                 check_piece(Segment{clothoid.b, clothoid.b}));
    const F length = clothoid.arc_length, k0 = abs(F(clothoid.start_curvature));
    const F k1 = abs(F(clothoid.start_curvature) + F(clothoid.sharpness) * length);
    const F bend = k0 > k1 ? k0 : k1;
    const Location first = location(clothoid, 0), last = location(clothoid, length);
    const Box& b = world_.bounds;
    const auto inside = [&](const Location& p, const F& margin) {
      return p.x - b.min.x() >= margin && p.y - b.min.y() >= margin && b.max.x() - p.x >= margin &&
             b.max.y() - p.y >= margin;
    };
    const auto halve = [&](const auto& again, const auto& judge, const Location& p, const F& from,
                           const Location& q, const F& to) -> ExactVerdict {
      const F deviation = bend * (to - from) * (to - from) / 8;
      const ExactVerdict here = judge(p, q, deviation);
      if (here != ExactVerdict::unknown || deviation < F("1e-30")) return here;
      const F middle = (from + to) / 2;
      const Location m = location(clothoid, middle);
      const ExactVerdict left = again(again, judge, p, from, m, middle);
      if (left == ExactVerdict::blocked) return left;
      return worse(left, again(again, judge, m, middle, q, to));
    };
    const auto in_bounds_throughout = [&](const Location& p, const Location& q,
                                          const F& deviation) {
      if (!inside(p, 0) || !inside(q, 0)) return ExactVerdict::blocked;
      const bool clear = inside(p, deviation) && inside(q, deviation);
      return clear ? ExactVerdict::free : ExactVerdict::unknown;
    };
    verdict = worse(verdict, halve(halve, in_bounds_throughout, first, 0, last, length));
    const Box hull = Box::around({clothoid.a, clothoid.b})
                         .inflated(static_cast<double>(bend * length * length) + 1e-9);
    for (const Part& part : parts_) {
      if (verdict == ExactVerdict::blocked) return verdict;
      if (is_far(part, hull)) continue;
      const Location u{F(part.a.x()), F(part.a.y())}, v{F(part.b.x()), F(part.b.y())};
      const F least = F(part.radius) + F(r_);
      const auto keeps_off = [&](const Location& p, const Location& q, const F& deviation) {
        if (to_segment(p, u, v) < least || to_segment(q, u, v) < least) {
          return ExactVerdict::blocked;
        }
        const bool clear = between(p, q, u, v) - deviation >= least;
        return clear ? ExactVerdict::free : ExactVerdict::unknown;
      };
      verdict = worse(verdict, halve(halve, keeps_off, first, 0, last, length));
    }
    return verdict;
  }

  static constexpr int max_depth = 48;

  const Workspace& world_;
  double r_;
  std::vector<Part> parts_;
};

ExactChecker::ExactChecker(const Workspace& world) : judge_(std::make_shared<const Judge>(world)) {}

ExactVerdict ExactChecker::check(const Curve& curve) const { return judge_->check(curve); }
ExactVerdict ExactChecker::check(const Piece& piece) const { return judge_->check(piece); }

}  // namespace tutavia::test
