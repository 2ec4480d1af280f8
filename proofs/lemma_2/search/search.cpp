// Searches the tree of boxes for Lemma 2's block half.  Nothing here is trusted: the tree that it
// prints is replayed by proofs/lemma_2/replay.py in integers.  See README.md.
//
// Usage: search TABLE CLASS KAPPA TAU[,TAU2] DEPTH [HEIGHT [edges | nearest]] > tree
// With TAU < TAU2 for all thresholds between them at once; then without HEIGHT.
// The tree in preorder, a byte a node: '0' a leaf, '1' to '4' a split of x, y, m_e or m_f.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

using std::vector;

const int N = 8;  // x, y, m_e, m_f and a symbol for the column (ray, level) where m may be 0
const double MARGIN = 2e-5;
double KAPPA, TAU, TAU2, HEIGHT;  // thresholds from TAU to TAU2
int CLASS, DEPTH, NEAREST, EDGES;

struct Form {  // c + sum a_i e_i + r e, each e in [-1, 1]
  double c = 0, a[N] = {0}, r = 0;
  Form(double v = 0) : c(v) {}
  double linear() const { double s = 0; for (int i = 0; i < N; i++) s += std::fabs(a[i]); return s; }
  double rad() const { return linear() + r; }
};
Form operator+(const Form& p, const Form& q) {
  Form s; s.c = p.c + q.c; s.r = p.r + q.r;
  for (int i = 0; i < N; i++) s.a[i] = p.a[i] + q.a[i];
  return s;
}
Form operator*(double k, const Form& p) {
  Form s; s.c = k * p.c; s.r = std::fabs(k) * p.r;
  for (int i = 0; i < N; i++) s.a[i] = k * p.a[i];
  return s;
}
Form operator-(const Form& p, const Form& q) { return p + (-1.0) * q; }
Form operator*(const Form& p, const Form& q) {
  Form s; s.c = p.c * q.c;
  double diagonal = 0;
  for (int i = 0; i < N; i++) {
    s.a[i] = p.c * q.a[i] + q.c * p.a[i];
    double d = p.a[i] * q.a[i] / 2;
    s.c += d; diagonal += std::fabs(d);
  }
  s.r = std::fabs(p.c) * q.r + std::fabs(q.c) * p.r + p.rad() * q.rad() - diagonal;
  return s;
}
// p / q, or a constant between lo and hi if that is known and no worse; own: its symbol, or -1
Form divided(const Form& p, const Form& q, const Form& plus, double lo, double hi, int own) {
  Form fixed((lo + hi) / 2);
  (own >= 0 ? fixed.a[own] : fixed.r) = (hi - lo) / 2;
  double d = std::fabs(q.c), ro = q.rad();
  if (ro >= 0.87 * d) return fixed;
  double q0 = p.c / q.c;
  Form R = p - q0 * q;
  Form s = (1 / q.c) * R;
  s.r += R.rad() / d * (ro / (d - ro));
  s = s + Form(q0) + plus;
  return s.rad() > fixed.rad() ? fixed : s;
}

struct Kind { int cell1, part1, cell2, part2, below, above; };
struct Point { int name = 0, ray = 0, level = 0, column = 0, part = 0, clear = 0, k = 0, l = 0; int base = 0; vector<Point> sub; };
typedef vector<int> Ids;
typedef vector<Ids> Outcomes;
struct Plan { Outcomes corner[4]; };
struct Pair { int e, f, plan; };

vector<Kind> kinds; vector<vector<Point>> rings; vector<Plan> plans; vector<Pair> pairs;

Point read_point(std::istream& in) {
  Point p; in >> p.name;
  if (p.name == 1) in >> p.k >> p.l;
  if (p.name == 2) in >> p.ray >> p.level >> p.part;
  if (p.name == 3) in >> p.ray >> p.level >> p.column >> p.part >> p.clear;
  if (p.name == 4) { p.sub.push_back(read_point(in)); p.sub.push_back(read_point(in)); in >> p.k >> p.l; }
  return p;
}
void read_table(const char* name) {
  std::ifstream in(name); int n; in >> n; kinds.resize(n);
  for (auto& k : kinds) in >> k.cell1 >> k.part1 >> k.cell2 >> k.part2 >> k.below >> k.above;
  in >> n; rings.resize(n);
  for (auto& r : rings) { int m; in >> m; for (int i = 0; i < m; i++) r.push_back(read_point(in)); }
  in >> n; plans.resize(n);
  for (auto& p : plans) for (auto& c : p.corner) {
    int m; in >> m; c.resize(m);
    for (auto& o : c) { int s; in >> s; o.resize(s); for (int& i : o) in >> i; }
  }
  in >> n; pairs.resize(n);
  for (auto& p : pairs) in >> p.e >> p.f >> p.plan;
}

struct Box { double lo[4], hi[4]; };
struct XY { Form x, y; };

struct Heir {  // what a box hands on to its halves: rings that are good, pairs that are possible
  vector<signed char> known; vector<int> pairs;
};

struct State {
  Form p[4]; Box b; const Heir* heir;
  vector<signed char> known; vector<int> possible_pairs;
  State(const Box& box, const Heir* from) : b(box), heir(from), known(from ? from->known : vector<signed char>(rings.size(), -1)) {
    for (int i = 0; i < 4; i++) {
      p[i] = Form((box.lo[i] + box.hi[i]) / 2); p[i].a[i] = (box.hi[i] - box.lo[i]) / 2;
    }
  }
  static XY unturned(int q, const XY& z) {
    switch (q) {
      case 0: return z;
      case 1: return {z.y, Form(1) - z.x};
      case 2: return {Form(1) - z.x, Form(1) - z.y};
      default: return {Form(1) - z.y, z.x};
    }
  }
  static XY turned(int q, const XY& z) { return unturned((4 - q) % 4, z); }
  XY own(int ray) const { return unturned(ray ? CLASS : 0, {p[0], p[1]}); }
  Form at(int ray, const Form& height) const {
    XY v = own(ray);
    return v.x + (height - v.y) * p[2 + ray];
  }
  XY place(const Point& s) const {
    if (s.name == 0) return {p[0], p[1]};
    if (s.name == 1) return {Form(s.k), Form(s.l)};
    int ray = s.name == 4 ? s.sub[0].ray : s.ray, q = ray ? CLASS : 0;
    if (s.name == 2) return turned(q, {at(ray, Form(s.level)), Form(s.level)});
    XY v = own(ray);
    if (s.name == 3) {
      double lo = s.part == 0 ? 0 : s.part == 1 ? TAU : 1 - TAU2;
      double hi = s.part == 0 ? TAU2 : s.part == 1 ? 1 - TAU : 1;
      lo += s.level; hi += s.level;
      if (s.level == 0) lo = std::max(lo, std::min(hi, v.y.c - v.y.rad()));
      return turned(q, {Form(s.column), divided(Form(s.column) - v.x, p[2 + ray], v.y, lo, hi, 4 + 2 * ray + s.level)});
    }
    XY a = unturned(q, place(s.sub[1])), c = unturned(q, {Form(s.k), Form(s.l)});
    Form off_a = a.x - at(ray, a.y), off_c = c.x - at(ray, c.y);
    Form t = divided(off_a, off_a - off_c, Form(0), 0, 1, -1);
    return turned(q, {a.x + t * (c.x - a.x), a.y + t * (c.y - a.y)});
  }
  static bool wide(const Form& ux, const Form& uy, const Form& wx, const Form& wy) {
    Form t = ux * (wx + KAPPA * wy) + uy * (wy - KAPPA * wx);
    return t.c - t.rad() > MARGIN;
  }
  // The line of the block's frame that a crossing is on: its level, and whether it is a column
  static bool line(const Point& p, int& at) {
    int q = p.ray ? CLASS : 0; bool column = (p.name == 3) != (q % 2 == 1);
    int own = p.name == 3 ? p.column : p.level;
    at = q == 0 || (q == 1 && p.name == 3) || (q == 3 && p.name == 2) ? own : 1 - own;
    return column;
  }
  static bool crosses(const Point& p) { return p.name == 2 || p.name == 3; }
  // Is q a crossing on a line through the grid vertex g, at least tau away?  column: which line
  static bool aside(const Point& g, const Point& q, bool& column) {
    if (g.name != 1 || !crosses(q) || q.part != 1) return false;
    int at; column = line(q, at);
    return at == (column ? g.k : g.l);
  }
  static bool clear(const Point& q, const Point& g) {
    if (q.name == 2) return true;
    int t = q.ray ? CLASS : 0, k = q.column;
    for (int i = 0; i < 2; i++) if (q.clear >> i & 1) {
      int l = q.level + i, at[4][2] = {{k, l}, {1 - l, k}, {1 - k, 1 - l}, {l, 1 - k}};
      if (at[t][0] == g.k && at[t][1] == g.l) return true;
    }
    return false;
  }
  static bool on_ray(const Point& p, int ray) {
    return p.name == 0 || (p.name == 4 ? p.sub[0].ray == ray : p.name != 1 && p.ray == ray);
  }
  static bool not_negative(const Form& t, bool exact) { return t.c - t.rad() >= (exact ? -1e-12 : MARGIN); }
  bool long_side(const Point& p, const Point& q, const XY& a, const XY& b) const {
    bool column, other;
    if (p.name == 1 && q.name == 1) return true;
    if (aside(p, q, column) || aside(q, p, column)) return true;
    if (crosses(p) && crosses(q) && p.part == 1 && q.part == 1) {
      int at; column = line(p, at); other = line(q, at);
      if (column != other) return true;
    }
    Form x = b.x - a.x, y = b.y - a.y, t = x * x + y * y;
    return t.c - t.rad() > TAU * TAU + 2e-5;
  }
  static bool good(const Point* p[3], const XY* z[3]) {
    Form x[3], y[3];  // sides, from corner i to i + 1
    for (int i = 0; i < 3; i++) { x[i] = z[(i + 1) % 3]->x - z[i]->x; y[i] = z[(i + 1) % 3]->y - z[i]->y; }
    bool angle[3] = {false}, height[3] = {false};
    if (HEIGHT > 0) for (int g = 0; g < 3; g++) {
      int q = (g + 1) % 3, w = (g + 2) % 3; bool column[2] = {false}, beside[2];
      for (int turn = 0; turn < 2; turn++, std::swap(q, w)) {
        beside[turn] = aside(*p[g], *p[q], column[turn]);
        if (!beside[turn]) continue;
        if (clear(*p[q], *p[g]) && on_ray(*p[w], p[q]->ray)) height[(g + 1) % 3] = true;
        Form along = z[w]->y - z[g]->y, off = z[w]->x - z[g]->x;
        if (!column[turn]) std::swap(along, off);
        if (off.c < 0) off = -1.0 * off;
        bool exact = p[w]->name < 2;  // v or a grid vertex: no product, no rounding
        if (!not_negative(off - along, exact) || !not_negative(off + along, exact)) continue;
        angle[g] = true; height[w == (g + 1) % 3 ? g : w] = true;
      }
      if (beside[0] && beside[1] && column[0] != column[1]) height[(g + 1) % 3] = true;  // opposite g
    }
    Form cross = x[0] * y[1] - y[0] * x[1];
    if (cross.c - cross.rad() <= MARGIN) return false;
    for (int i = 0; i < 3; i++) {
      int before = (i + 2) % 3;
      if (!angle[i] && !wide(x[i], y[i], -1.0 * x[before], -1.0 * y[before])) return false;
    }
    if (HEIGHT > 0) {  // cross > h s follows from 2 l cross > h (s^2 + l^2), for any l > 0
      for (int i = 0; i < 3; i++) if (!height[i]) {
        Form s = x[i] * x[i] + y[i] * y[i];
        double l = (1 + std::floor(256 * std::sqrt(std::fabs(s.c)))) / 256;  // as the replay
        Form t = 2 * l * cross - HEIGHT * s;
        if (t.c - t.rad() - HEIGHT * l * l <= 2e-5) return false;
      }
    }
    return true;
  }
  bool ring(int id) {
    if (known[id] < 0) {
      const auto& r = rings[id]; int n = r.size();
      vector<XY> z; for (auto& s : r) z.push_back(place(s));
      bool ok[8][8] = {{false}};
      for (int i = 0; i + 1 < n; i++) ok[i][i + 1] = true;
      for (int w = 2; w < n; w++) for (int i = 0; i + w < n; i++) for (int k = i + 1; k < i + w && !ok[i][i + w]; k++)
        if (ok[i][k] && ok[k][i + w]) {
          const Point* p[3] = {&r[i], &r[k], &r[i + w]}; const XY* c[3] = {&z[i], &z[k], &z[i + w]};
          ok[i][i + w] = good(p, c);
        }
      known[id] = ok[0][n - 1];
      if (EDGES) for (int i = 0; i < n && known[id]; i++) known[id] = long_side(r[i], r[(i + 1) % n], z[i], z[(i + 1) % n]);
    }
    return known[id];
  }
  void range(int ray, double h, double& lo, double& hi) const {
    XY v = own(ray);
    double ylo = h - (v.y.c + v.y.rad()), yhi = h - (v.y.c - v.y.rad());
    double ml = b.lo[2 + ray], mh = b.hi[2 + ray];
    lo = v.x.c - v.x.rad() + std::min(std::min(ylo * ml, ylo * mh), std::min(yhi * ml, yhi * mh));
    hi = v.x.c + v.x.rad() + std::max(std::max(ylo * ml, ylo * mh), std::max(yhi * ml, yhi * mh));
  }
  static double bound(int cell, int part, bool upper) {
    if (cell == 2 && part == 1 && upper) return 9;
    if (cell == -2 && part == 1 && !upper) return -9;
    double t[3][2] = {{0, TAU2}, {TAU, 1 - TAU}, {1 - TAU2, 1}};
    return cell + t[part][upper];
  }
  static bool within(double lo, double hi, int cell, int part) {
    double l = bound(cell, part, false), h = bound(cell, part, true);
    const double eps = 1e-12;
    if (part == 0 ? hi <= l + eps : hi < l - eps) return false;
    if (part == 2 ? lo >= h - eps : lo > h + eps) return false;
    return true;
  }
  bool possible(int ray, const Kind& k) const {
    double lo, hi;
    range(ray, 1, lo, hi); if (!within(lo, hi, k.cell1, k.part1)) return false;
    range(ray, 2, lo, hi); if (!within(lo, hi, k.cell2, k.part2)) return false;
    int s1 = 3 * k.cell1 + k.part1, s2 = 3 * k.cell2 + k.part2;
    int sign = k.cell1 ? k.cell1 : (s2 > s1) - (s2 < s1);
    if (sign > 0 && b.hi[2 + ray] <= 0) return false;
    if (sign < 0 && b.lo[2 + ray] >= 0) return false;
    for (int level = 0; level < 2; level++) {
      int part = level ? k.above : k.below;
      if (part < 0) continue;
      int column = level ? std::max(k.cell1, k.cell2) : (k.cell1 == 1 ? 1 : 0);
      // Y < t iff X at t is beyond the column
      bool right = sign > 0;
      const double eps = 1e-12;
      if (part < 2) {  // Y <= upper bound
        range(ray, level + (part == 0 ? TAU2 : 1 - TAU), lo, hi);
        if (right ? hi < column - eps : lo > column + eps) return false;
        XY v = own(ray);  // below the crossing
        if (v.y.c - v.y.rad() >= level + (part == 0 ? TAU2 : 1 - TAU) - eps) return false;
      }
      if (part > 0) {
        range(ray, level + (part == 1 ? TAU : 1 - TAU2), lo, hi);
        if (right ? lo > column + eps : hi < column - eps) return false;
      }
    }
    return true;
  }
  // How many rings fail, in the best corner of each pair, at most; stops at a limit
  long failing(long limit) {
    vector<signed char> e(kinds.size(), -1), f(kinds.size(), -1);
    vector<int> score(plans.size(), -1);
    long sum = 0;
    int total = heir ? heir->pairs.size() : pairs.size();
    for (int i = 0; i < total; i++) {
      int id = heir ? heir->pairs[i] : i;
      auto& pair = pairs[id];
      if (e[pair.e] < 0) e[pair.e] = possible(0, kinds[pair.e]);
      if (!e[pair.e]) continue;
      if (f[pair.f] < 0) f[pair.f] = possible(1, kinds[pair.f]);
      if (!f[pair.f]) continue;
      possible_pairs.push_back(id);
      int& s = score[pair.plan];
      if (s < 0) {
        s = NEAREST ? 0 : 1000;
        for (int c = 0; c < 4; c++) {
          auto& corner = plans[pair.plan].corner[c];
          if (NEAREST) {  // every corner that may be the nearest must be good
            bool right = c / 2, top = c % 2;
            if ((right ? b.hi[0] < 0.5 : b.lo[0] > 0.5) || (top ? b.hi[1] < 0.5 : b.lo[1] > 0.5)) continue;
            for (auto& o : corner) { int bad = 0; for (int id : o) bad += !ring(id); s = std::max(s, bad); }
            continue;
          }
          int worst = 0;
          for (auto& o : corner) { int bad = 0; for (int id : o) { bad += !ring(id); if (bad >= s) break; } worst = std::max(worst, bad); if (worst >= s) break; }
          s = std::min(s, worst);
          if (!s) break;
        }
      }
      sum += s;
      if (sum > limit) return sum;
    }
    return sum;
  }
};

bool outside(const Box& b) {
  if (CLASS == 0 && b.hi[3] <= b.lo[2]) return true;
  if (CLASS == 1 && b.lo[3] >= b.hi[2]) return true;
  if (CLASS == 1 && b.lo[0] + b.lo[1] >= 1) return true;
  if (CLASS == 3 && b.lo[0] >= b.hi[1]) return true;
  return false;
}

long leaves = 0, stuck = 0, nodes = 0; int deepest = 0;
double done = 0;  // the share of all parameters
std::string tree;

// Rings that fail; what is handed on
long value(const Box& b, long limit, const Heir* from, Heir* to) {
  if (outside(b)) return 0;
  State s(b, from);
  long fails = s.failing(limit);
  if (!fails && from) fails = State(b, nullptr).failing(0);  // as the replay will see it
  for (auto& k : s.known) if (k == 0) k = -1;
  to->known = std::move(s.known); to->pairs = std::move(s.possible_pairs);
  return fails;
}

void halves(const Box& b, int d, Box& l, Box& h) { l = h = b; l.hi[d] = h.lo[d] = (b.lo[d] + b.hi[d]) / 2; }

void search(const Box& b, int depth, long fails, const Heir* heir) {
  nodes++;
  deepest = std::max(deepest, depth);
  if (nodes % 20000 == 0) fprintf(stderr, "%.4f done %ld nodes %ld leaves %ld stuck, at depth %d x %.4f y %.4f me %.4f mf %.4f\n", done, nodes, leaves, stuck, depth, b.lo[0], b.lo[1], b.lo[2], b.lo[3]);
  if (!fails) { leaves++; done += std::ldexp(1.0, -depth); tree += '0'; return; }
  if (depth >= DEPTH) {
    stuck++; done += std::ldexp(1.0, -depth); tree += 'S';
    if (stuck < 30) fprintf(stderr, "STUCK x %.9f y %.9f me %.9f mf %.9f widths %g %g %g %g fails %ld\n", b.lo[0], b.lo[1], b.lo[2], b.lo[3], b.hi[0]-b.lo[0], b.hi[1]-b.lo[1], b.hi[2]-b.lo[2], b.hi[3]-b.lo[3], fails);
    return;
  }
  int best = 0; long best_l = 0, best_h = 0; double best_score = 1e300;
  Heir heir_l, heir_h;
  double widest = 0; double w[4];
  for (int d = 0; d < 4; d++) { w[d] = (b.hi[d] - b.lo[d]); widest = std::max(widest, w[d]); }
  for (int d = 0; d < 4; d++) {
    if (w[d] < widest / 16) continue;
    Box l, h; halves(b, d, l, h);
    const long none = 1L << 40;
    if (widest > 0.5) {  // too large to try
      if (w[d] == widest) { best = d; best_l = best_h = 1; heir_l = heir_h = *heir; break; }
      continue;
    }
    Heir to_l, to_h;
    double bias = 0.3 * double(fails) * (1 - w[d] / widest) - 0.4 * double(fails);
    long limit = best_score > 1e200 ? none : (long)std::max(0.0, best_score - bias) + 1;
    long vl = value(l, limit, heir, &to_l);
    if (vl > limit) continue;
    long vh = value(h, limit - vl, heir, &to_h);
    double score = double(vl) + double(vh) + 0.3 * double(fails) * (1 - w[d] / widest);
    score -= (vl == 0) * 0.2 * fails + (vh == 0) * 0.2 * fails;
    if (score < best_score) {
      best_score = score; best = d; best_l = vl; best_h = vh;
      heir_l = std::move(to_l); heir_h = std::move(to_h);
    }
  }
  tree += char('1' + best);
  Box l, h; halves(b, best, l, h);
  search(l, depth + 1, best_l, &heir_l); search(h, depth + 1, best_h, &heir_h);
}

int main(int argc, char** argv) {
  if (argc < 6) { fprintf(stderr, "usage: search TABLE CLASS KAPPA TAU DEPTH [HEIGHT [NEAREST]]\n"); return 2; }
  read_table(argv[1]); CLASS = atoi(argv[2]); KAPPA = atof(argv[3]); TAU = TAU2 = atof(argv[4]); DEPTH = atoi(argv[5]);
  if (const char* more = strchr(argv[4], ',')) TAU2 = atof(more + 1);
  HEIGHT = argc > 6 ? atof(argv[6]) : 0; EDGES = argc > 7 && argv[7][0] == 'e'; NEAREST = argc > 7 && argv[7][0] == 'n';
  Box b = {{0, 0, -1, -1}, {1, 1, 1, 1}};
  if (CLASS == 0) b.hi[0] = 0.5;
  if (CLASS == 2) b.hi[1] = 0.5;
  Heir all; all.known.assign(rings.size(), -1);
  for (size_t i = 0; i < pairs.size(); i++) all.pairs.push_back(i);
  search(b, 0, 1, &all);
  std::cout << tree << "\n";
  fprintf(stderr, "class %d kappa %g: %ld leaves, %ld nodes, %ld stuck, depth %d\n", CLASS, KAPPA, leaves, nodes, stuck, deepest);
  return stuck ? 1 : 0;
}
