#pragma once

#include <optional>
#include <QByteArray>
#include <QList>

namespace lds::app {

/// Takes lines out of whatever bytes arrive. Never keeps more than one line, cut at its longest.
class LineSplitter {
public:
    struct Line {
        QByteArray text;       ///< Without its end.
        bool overlong = false; ///< Was longer than allowed; the text is gone.
    };

    explicit LineSplitter(qsizetype longest)
        : m_longest(longest)
    {}
    /// Lines end with a line feed, a carriage return before it being dropped.
    QList<Line> feed(const QByteArray& bytes);
    /// What stands after the last line feed when nothing more comes.
    std::optional<Line> rest();

private:
    Line takeLine();

    qsizetype m_longest;
    QByteArray m_line;
    bool m_overlong = false;
};

} // namespace lds::app
