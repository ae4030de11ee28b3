#include "line_splitter.h"

#include <utility>

namespace lds::app {

QList<LineSplitter::Line> LineSplitter::feed(const QByteArray& bytes)
{
    QList<Line> lines;
    qsizetype start = 0;
    while (start < bytes.size()) {
        const qsizetype end = bytes.indexOf('\n', start);
        const qsizetype count = (end < 0 ? bytes.size() : end) - start;
        if (m_overlong || m_line.size() + count > m_longest) {
            m_overlong = true;
            m_line.clear();
        } else {
            m_line.append(bytes.constData() + start, count);
        }
        if (end < 0)
            break;
        lines.append(takeLine());
        start = end + 1;
    }
    return lines;
}

std::optional<LineSplitter::Line> LineSplitter::rest()
{
    if (m_line.isEmpty() && !m_overlong)
        return std::nullopt;
    return takeLine();
}

LineSplitter::Line LineSplitter::takeLine()
{
    Line line{std::exchange(m_line, {}), std::exchange(m_overlong, false)};
    if (line.text.endsWith('\r'))
        line.text.chop(1);
    return line;
}

} // namespace lds::app
