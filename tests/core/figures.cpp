#include "figures.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <vector>

namespace figures {

namespace {

constexpr double FAR_LESS = 20.0;

struct Figure {
	std::string table, what, expected, measured;
	double error = 0.0;
};

/// Written when the program ends.
class Book {
public:
	~Book() {
		const char *path = std::getenv("FIGURES");
		if (!path) {
			return;
		}
		std::ofstream file(path);
		for (const Figure &figure : all) {
			file << figure.table << '\t' << figure.what << '\t' << figure.expected << '\t' << figure.measured << '\n';
		}
	}

	Figure &of(const std::string &table, const std::string &what) {
		const auto found = std::find_if(all.begin(), all.end(),
				[&](const Figure &figure) { return figure.table == table && figure.what == what; });
		if (found != all.end()) {
			return *found;
		}
		all.push_back({ table, what, {}, {} });
		return all.back();
	}

private:
	std::vector<Figure> all;
};

Book &book() {
	static Book all;
	return all;
}

std::string number(double value, int digits, const char *unit) {
	char text[64];
	std::snprintf(text, sizeof text, "%.*f%s", digits, value, unit);
	return text;
}

std::string percent(double share) {
	char text[64];
	std::snprintf(text, sizeof text, "%.2g %%", 100.0 * share);
	return text;
}

} // namespace

void record(const std::string &table, const std::string &what, double expected, double measured, int digits,
		const char *unit) {
	Figure &figure = book().of(table, what);
	figure.expected = number(expected, digits, unit);
	figure.measured = number(measured, digits, unit);
}

void record_error(const std::string &table, const std::string &what, double max, double error) {
	Figure &figure = book().of(table, what);
	figure.error = std::max(figure.error, std::fabs(error));
	figure.expected = "within " + percent(max);
	const double little = max / FAR_LESS;
	figure.measured = figure.error < little ? "under " + percent(little) : percent(figure.error);
}

} // namespace figures
