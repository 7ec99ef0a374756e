// SPDX-License-Identifier: BSD-3-Clause
#include "clip/features/subjects.hpp"

#include <algorithm>
#include <set>

#include "clip/text/text_cursor.hpp"

namespace stltsa::clip {
namespace {

std::string in_a_list(const std::vector<std::string>& subjects) {
    return list_in_quotes(subjects, 20);
}

/// Each subject once, in the order of the points.
std::vector<std::string> subjects_in(const std::vector<std::string>& points) {
    std::vector<std::string> subjects;
    std::set<std::string_view> known;
    for (const std::string& point : points)
        if (const auto subject = subject_of(point);
            !subject.empty() && known.insert(subject).second)
            subjects.emplace_back(subject);
    return subjects;
}

} // namespace

std::string_view subject_of(std::string_view point) {
    const std::size_t colon = point.find(':');
    const bool splits = colon != point.npos && !trim(point.substr(colon + 1)).empty();
    return splits ? trim(point.substr(0, colon)) : std::string_view();
}

std::string one_subject(const std::vector<std::string>& subjects, const std::string& wanted,
                        const std::string& file) {
    if (wanted.empty() && subjects.size() > 1)
        fail(Status::argument, "{}: there are {} subjects, {}: choose one with option subject",
             file, subjects.size(), in_a_list(subjects));
    if (!wanted.empty() && std::ranges::find(subjects, wanted) == subjects.end())
        fail(Status::argument, "{}: option subject is {}, but {}", file, in_quotes(wanted),
             subjects.empty() ? "the file names no subjects"
                              : "the subjects are " + in_a_list(subjects));
    return wanted.empty() && !subjects.empty() ? subjects[0] : wanted;
}

std::string subject_note(const std::vector<std::string>& subjects, const std::string& taken) {
    if (subjects.size() < 2)
        return {};
    return format_text("subject {} of {}: {}", in_quotes(taken), subjects.size(),
                       in_a_list(subjects));
}

SubjectPoints points_of_subject(const std::vector<std::string>& names, const std::string& wanted,
                                const std::string& file) {
    const std::vector<std::string> subjects = subjects_in(names);
    SubjectPoints found;
    if (!subjects.empty())
        found.subject = one_subject(subjects, wanted, file);
    const bool all = wanted.empty();
    std::size_t of_none = 0;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::string_view subject = subject_of(names[i]);
        if (all || subject == found.subject)
            found.points.push_back(i);
        else
            of_none += subject.empty() ? 1 : 0;
    }
    found.note = subject_note(subjects, found.subject);
    if (of_none > 0)
        found.note += format_text("{}{} points of no subject are left out",
                                  found.note.empty() ? "" : "; ", of_none);
    return found;
}

std::vector<std::size_t> take_subject(Clip& clip, const std::vector<std::string>& names,
                                      const std::string& wanted, const std::string& file) {
    SubjectPoints chosen =
        points_of_subject(names, clip.subject.empty() ? wanted : std::string(), file);
    if (clip.subject.empty())
        clip.subject = std::move(chosen.subject);
    if (!chosen.note.empty())
        clip.notes.push_back(std::move(chosen.note));
    return std::move(chosen.points);
}

} // namespace stltsa::clip
