// Writes sections, tables and figures (as SVG) with one style sheet into a file without external references.

#include "app/report/pages/html_report.h"

#include <algorithm>
#include <string_view>
#include <variant>

#include "app/figures/figure_files.h"
#include "app/findings/outcome/display_number.h"

namespace asperity {

namespace {

constexpr const char* kStyle = R"(
:root { color: #1a1a1a; background: #ffffff; font: 16px/1.5 system-ui, "DejaVu Sans", sans-serif; }
body { margin: 0 auto; max-width: 60rem; padding: 2rem 1.5rem 4rem; }
h1 { font-size: 2rem; line-height: 1.2; margin: 0 0 .25rem; }
h2 { font-size: 1.45rem; line-height: 1.25; margin: 3.5rem 0 .5rem; padding-top: 1.5rem; border-top: 2px solid #1a1a1a; }
h3 { font-size: 1.1rem; margin: 2rem 0 .5rem; }
p, ul { margin: 0 0 .8rem; max-width: 44rem; }
p.under { color: #555555; }
p.lead { font-weight: 600; }
p.notice { border-left: 4px solid #b36b00; padding: .1rem 0 .1rem .8rem; }
nav ul { list-style: none; padding-left: 1.2rem; margin: 0; }
nav > ul { padding-left: 0; margin-bottom: 1rem; }
nav > ul > li { margin-top: .5rem; }
nav ul ul li { display: inline; font-size: .9rem; }
nav ul ul li + li::before { content: " · "; }
a { color: #0b57a4; }
.mark { display: inline-block; font-size: .8rem; font-weight: 600; line-height: 1; padding: .3rem .5rem; border-radius: 3px; vertical-align: middle; white-space: nowrap; }
.pilot .mark { background: #ffd47a; color: #1a1a1a; }
.virtual .mark { background: #5b3a8e; color: #ffffff; }
.scroll { overflow-x: auto; margin: 1.2rem 0 1.6rem; }
table { border-collapse: collapse; font-size: .875rem; font-variant-numeric: tabular-nums; border-top: 1.5px solid #1a1a1a; border-bottom: 1.5px solid #1a1a1a; }
caption { caption-side: top; text-align: left; font-weight: 600; padding-bottom: .4rem; font-size: .95rem; }
th, td { text-align: left; padding: .22rem .9rem .22rem 0; vertical-align: top; font-weight: normal; }
thead th { border-bottom: 1px solid #1a1a1a; vertical-align: bottom; font-weight: 600; }
th.n, td.n { text-align: right; }
.reference table { font-size: .8rem; }
.note { font-size: .85rem; color: #444444; }
.long { overflow-wrap: anywhere; }
figure { margin: 1.4rem 0 1.8rem; }
figure svg { max-width: 100%; height: auto; }
figcaption { font-size: .875rem; max-width: 44rem; }
footer { margin-top: 3rem; border-top: 1px solid #bbbbbb; padding-top: .8rem; font-size: .85rem; color: #555555; }
@page { size: A4; margin: 20mm; }
@media print {
  :root { font-size: 10pt; }
  body { max-width: none; padding: 0; }
  nav, .scroll { overflow: visible; }
  section.chapter { break-before: page; }
  h2, h3, caption, p.lead, p.lead + p { break-after: avoid; }
  tr, figure, p { break-inside: avoid; }
  thead { display: table-header-group; }
  a { color: inherit; text-decoration: none; }
  .mark { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
}
)";

/// As text or as the value of an attribute, in both HTML and XML.
std::string escaped(std::string_view text) {
  std::string out{};
  for (const char letter : text) {
    switch (letter) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default:
        // XML permits no other control characters.
        out += static_cast<unsigned char>(letter) < 0x20 && letter != '\n' && letter != '\t'
                   ? ' '
                   : letter;
    }
  }
  return out;
}

/// With the line breaks of the text, and none within its numbers.
std::string with_breaks(const std::string& text) {
  std::string out{};
  for (const char letter : escaped(with_numbers_unbroken(text))) {
    if (letter == '\n') {
      out += "<br/>";
    } else {
      out += letter;
    }
  }
  return out;
}

/// The class of a cell of words: hashes and long names may break anywhere, short words nowhere.
std::string class_of_words(const std::string& text) {
  constexpr std::size_t kLongName = 24;
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find_first_of(" \n", begin), text.size());
    if (end - begin > kLongName) return " class=\"long\"";
    begin = end + 1;
  }
  return {};
}

std::string mark_of(const ReportChapter& chapter) {
  if (chapter.mark.empty()) return {};
  return " <span class=\"mark\">" + escaped(chapter.mark) + "</span>";
}

/// As a string of a style sheet that is valid in HTML and in XML.
std::string css_string(const std::string& text) {
  std::string out = "\"";
  for (const char letter : text) {
    const bool is_plain = letter != '<' && letter != '>' && letter != '&' && letter != '"' &&
                          letter != '\\' && static_cast<unsigned char>(letter) >= 0x20;
    if (is_plain) out += letter;
  }
  return out + '"';
}

class HtmlParts final {
 public:
  void operator()(const ReportText& part) {
    switch (part.tone) {
      case ReportText::Tone::plain:
        out_ += "<p>";
        break;
      case ReportText::Tone::lead:
        out_ += "<p class=\"lead\">";
        break;
      case ReportText::Tone::notice:
        out_ += "<p class=\"notice\">";
        break;
    }
    out_ += with_breaks(part.text) + "</p>\n";
  }

  void operator()(const ReportList& part) {
    out_ += "<ul>\n";
    for (const std::string& item : part.items) out_ += "<li>" + with_breaks(item) + "</li>\n";
    out_ += "</ul>\n";
  }

  void operator()(const ReportTable& part) {
    const std::string title = "Table " + std::to_string(part.number) + ". " + part.title;
    out_ += part.is_reference ? "<div class=\"scroll reference\"" : "<div class=\"scroll\"";
    // A scrollable region has to be reachable by keyboard.
    out_ += " role=\"region\" tabindex=\"0\" aria-label=\"" + escaped(title) + "\">\n<table>\n";
    out_ += "<caption>" + escaped(title) + "</caption>\n<thead><tr>";
    for (const ReportColumn& column : part.columns) {
      out_ += column.holds_numbers ? "<th scope=\"col\" class=\"n\">" : "<th scope=\"col\">";
      out_ += escaped(column.heading) + "</th>";
    }
    out_ += "</tr></thead>\n<tbody>\n";
    for (const std::vector<std::string>& row : part.rows) {
      out_ += "<tr>";
      for (std::size_t i = 0; i < row.size(); ++i) {
        const bool numbers = part.columns[i].holds_numbers;
        const bool names_the_row = i == 0 && !numbers;
        const std::string element = names_the_row ? "th" : "td";
        out_ += '<' + element + (names_the_row ? " scope=\"row\"" : "") +
                (numbers ? " class=\"n\"" : class_of_words(row[i])) + '>' + with_breaks(row[i]) +
                "</" + element + '>';
      }
      out_ += "</tr>\n";
    }
    out_ += "</tbody>\n</table>\n";
    if (!part.note.empty()) out_ += "<p class=\"note\">" + with_breaks(part.note) + "</p>\n";
    out_ += "</div>\n";
  }

  void operator()(const ReportFigure& part) {
    const Figure& figure = part.figure;
    const std::string title = figure.title.english();
    if (!figure.is_drawn()) {
      out_ += "<p><strong>" + escaped(title) + ".</strong> " +
              escaped(figure.instead.as_sentence().english()) + "</p>\n";
      return;
    }
    const std::string svg = svg_of(figure);
    const std::size_t begin = svg.find("<svg");
    const std::string words = "Figure " + std::to_string(part.number) + ". " + title;
    out_ += "<figure>\n<div role=\"img\" aria-label=\"" + escaped(words) + "\">\n" +
            svg.substr(begin == std::string::npos ? 0 : begin) + "\n</div>\n<figcaption><strong>" +
            escaped(words) + ".</strong> " + with_breaks(figure.note.english()) +
            "</figcaption>\n</figure>\n";
  }

  std::string take() { return std::move(out_); }

 private:
  std::string out_{};
};

std::string anchor_of(std::size_t chapter) { return "chapter-" + std::to_string(chapter + 1); }

std::string anchor_of(std::size_t chapter, std::size_t section) {
  return anchor_of(chapter) + '-' + std::to_string(section + 1);
}

/// The heading of every printed page of a chapter.
std::string page_rules_of(const Report& report) {
  std::string rules{};
  for (std::size_t i = 0; i < report.chapters.size(); ++i) {
    if (report.chapters[i].mark.empty()) continue;
    const std::string name = anchor_of(i);
    rules += "@page " + name + " { @top-right { content: " + css_string(report.chapters[i].mark) +
             "; } }\n@media print { #" + name + " { page: " + name + "; } }\n";
  }
  return rules;
}

std::string contents_of(const Report& report) {
  std::string out = "<nav aria-label=\"Contents\">\n<ul>\n";
  for (std::size_t i = 0; i < report.chapters.size(); ++i) {
    const ReportChapter& chapter = report.chapters[i];
    out += std::string("<li class=\"") + text_of(chapter.group) + "\"><a href=\"#" + anchor_of(i) +
           "\">" + escaped(chapter.heading) + "</a>" + mark_of(chapter) + "\n<ul>\n";
    for (std::size_t k = 0; k < chapter.sections.size(); ++k) {
      out += "<li><a href=\"#" + anchor_of(i, k) + "\">" + escaped(chapter.sections[k].heading) +
             "</a></li>\n";
    }
    out += "</ul></li>\n";
  }
  return out + "</ul>\n</nav>\n";
}

}  // namespace

std::string html_of(const Report& report, const std::stop_token& stop,
                    const std::function<void(double)>& progress) {
  std::string out =
      "<!DOCTYPE html>\n<html lang=\"en\" xmlns=\"http://www.w3.org/1999/xhtml\">\n<head>\n"
      "<meta charset=\"utf-8\"/>\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
      "<meta name=\"generator\" content=\"" +
      escaped(report.program) + "\"/>\n<title>" + escaped(report.title) + "</title>\n<style>" +
      kStyle + page_rules_of(report) + "</style>\n</head>\n<body>\n<header>\n<h1>" +
      escaped(report.title) + "</h1>\n<p class=\"under\">" + escaped(report.subtitle) +
      ".</p>\n</header>\n";
  out += contents_of(report) + "<main>\n";
  for (std::size_t i = 0; i < report.chapters.size(); ++i) {
    const ReportChapter& chapter = report.chapters[i];
    out += std::string("<section class=\"chapter ") + text_of(chapter.group) + "\" id=\"" +
           anchor_of(i) + "\">\n<h2>" + escaped(chapter.heading) + mark_of(chapter) + "</h2>\n";
    for (std::size_t k = 0; k < chapter.sections.size(); ++k) {
      if (stop.stop_requested()) return out;
      const ReportSection& section = chapter.sections[k];
      out += "<section id=\"" + anchor_of(i, k) + "\">\n<h3>" + escaped(section.heading) +
             mark_of(chapter) + "</h3>\n";
      HtmlParts parts{};
      for (const ReportPart& part : section.parts) std::visit(parts, part);
      out += parts.take() + "</section>\n";
    }
    out += "</section>\n";
    if (progress) {
      progress(static_cast<double>(i + 1) / static_cast<double>(report.chapters.size()));
    }
  }
  return out + "</main>\n<footer>Made by " + escaped(report.program) +
         ".</footer>\n</body>\n</html>\n";
}

}  // namespace asperity
