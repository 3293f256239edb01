#pragma once

#include <fstream>
#include <string>
#include <vector>

namespace test_support {

/// Rows of a comma-separated file without its header; fields may stand in quotes.
inline std::vector<std::vector<std::string>> csv_table(const std::string& path)
{
    std::ifstream in(path);
    std::vector<std::vector<std::string>> rows;
    std::string line;
    std::getline(in, line);
    while (std::getline(in, line)) {
        std::vector<std::string> row(1);
        bool quoted = false;
        for (const char c : line) {
            if (c == '"') quoted = !quoted;
            else if (c == ',' && !quoted) row.emplace_back();
            else if (c != '\r') row.back() += c;
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

}  // namespace test_support
