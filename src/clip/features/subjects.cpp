// SPDX-License-Identifier: BSD-3-Clause
#include "clip/features/subjects.hpp"

#include <algorithm>

#include "clip/text/text_cursor.hpp"

namespace stltsa::clip {
namespace {

std::string in_a_list(const std::vector<std::string>& subjects) {
    return list_in_quotes(subjects, 20);
}

/// What is not known of subjects, and taken for one.
std::string doubt(const SubjectsOfNames& known, const std::vector<std::string>& subjects,
                  const std::vector<Subject>& stated) {
    if (known.doubtful)
        return format_text("points of the same names are read as those of one subject: if they are "
                           "of several, {}, choose one with option subject",
                           in_a_list(subjects));
    if (stated.size() < 2 || subjects.size() > 1)
        return {};
    std::vector<std::string> names;
    for (const Subject& subject : stated)
        names.push_back(subject.name);
    return format_text("the file has {} subjects, {}, but does not say whose each point is: all "
                       "are read as those of one",
                       stated.size(), in_a_list(names));
}

} // namespace

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

bool SubjectPoints::is_of_other(std::string_view name) const {
    return leadings.of(name).value_or(taken) != taken;
}

SubjectPoints points_of_subject(const std::vector<std::string>& names, const std::string& wanted,
                                const std::string& file, const std::vector<Subject>& stated,
                                Named kind) {
    const SubjectsOfNames known = subjects_of_names(names, stated, kind);
    std::vector<std::string> subjects;
    for (const Subject& subject : known.subjects)
        subjects.push_back(subject.name);
    SubjectPoints found;
    const bool all =
        subjects.empty() || (wanted.empty() && (known.doubtful || subjects.size() < 2));
    if (all)
        found.note = doubt(known, subjects, stated);
    if (!subjects.empty() && !(all && known.doubtful))
        found.subject = one_subject(subjects, wanted, file);
    found.taken =
        static_cast<std::size_t>(std::ranges::find(subjects, found.subject) - subjects.begin());
    std::size_t of_none = 0;
    for (std::size_t i = 0; i < names.size(); ++i)
        if (all || known.of[i] == found.taken)
            found.points.push_back(i);
        else
            of_none += known.of[i] ? 0 : 1;
    for (std::size_t s = 0; s < subjects.size() && !all; ++s)
        found.leadings.add(known.subjects[s].leading, s);
    if (!all)
        found.note = subject_note(subjects, found.subject);
    if (of_none > 0)
        found.note += format_text("{}{} points of no subject are left out",
                                  found.note.empty() ? "" : "; ", of_none);
    return found;
}

SubjectPoints take_subject(Clip& clip, const std::vector<std::string>& names,
                           const std::string& wanted, const std::string& file,
                           const std::vector<Subject>& stated, Named kind) {
    const bool by_rows = !clip.subject.empty();
    SubjectPoints chosen = points_of_subject(names, by_rows ? "" : wanted, file, stated, kind);
    if (!by_rows)
        clip.subject = chosen.subject;
    if (!chosen.note.empty())
        clip.notes.push_back(chosen.note);
    return chosen;
}

} // namespace stltsa::clip
