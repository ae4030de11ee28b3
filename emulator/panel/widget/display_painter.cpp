#include "display_painter.h"

#include <cmath>
#include <QColor>
#include <QCoreApplication>
#include <QFont>
#include <QFontDatabase>
#include <QFontMetricsF>
#include <QPainter>
#include <QStringList>

namespace lds::emulator {

using namespace Qt::StringLiterals;

namespace {

constexpr double dotsAcross = 128; ///< The unit in which places are given below: 128 × 64 dots.
constexpr double dimmed = 0.35;

const QColor black(0x04, 0x05, 0x07);
const QColor white(0xf2, 0xf6, 0xff);
const QColor grey(0x9a, 0xa4, 0xb2);
const QColor amber(0xff, 0xb0, 0x2e);
const QColor green(0x5c, 0xe0, 0x8a);
const QColor red(0xff, 0x6b, 0x5e);
const QColor blue(0x6c, 0xb8, 0xff);

/// U+2212 instead of the hyphen, which is too short beside digits.
QString withMinus(QString text) { return text.replace(u'-', QChar(0x2212)); }

QStringList families(PanelLanguage language)
{
    switch (language) {
    case PanelLanguage::Japanese:
        return {u"Noto Sans CJK JP"_s, u"Yu Gothic UI"_s, u"Hiragino Sans"_s, QFont().family()};
    case PanelLanguage::SimplifiedChinese:
        return {u"Noto Sans CJK SC"_s, u"Microsoft YaHei UI"_s, u"PingFang SC"_s, QFont().family()};
    case PanelLanguage::English:
        break;
    }
    return {QFont().family()};
}

/// Draws on the display in dots; fonts are made at their real size, so that nothing is scaled.
class Canvas {
public:
    Canvas(QPainter& painter, const QRectF& rect, PanelLanguage language)
        : m_painter(painter)
        , m_rect(rect)
        , m_dot(rect.width() / dotsAcross)
    {
        m_words.setFamilies(families(language));
        m_digits = QFontDatabase::systemFont(QFontDatabase::FixedFont);
        m_digits.setWeight(QFont::DemiBold);
    }

    QRectF place(const QRectF& dots) const
    {
        return {m_rect.x() + dots.x() * m_dot, m_rect.y() + dots.y() * m_dot, dots.width() * m_dot,
                dots.height() * m_dot};
    }
    void fill(const QRectF& dots, const QColor& color) { m_painter.fillRect(place(dots), color); }

    /// Words as large as fit, up to `size` dots high, on as many lines as there is room for.
    void words(const QRectF& dots, const QString& text, double size, int flags, const QColor& color,
               QFont::Weight weight = QFont::Normal)
    {
        QFont font = m_words;
        font.setWeight(weight);
        draw(dots, text, font, size, flags | Qt::TextWordWrap, color);
    }
    /// Characters of one width on one line, the one at `edited` on a light ground.
    void figures(const QRectF& dots, const QString& text, double size, int edited, const QColor& color)
    {
        QFont font = m_digits;
        const QRectF area = place(dots);
        double cell = 0;
        for (int pixels = pixelSize(size); pixels > 1; --pixels) {
            font.setPixelSize(pixels);
            cell = QFontMetricsF(font).horizontalAdvance(u'0');
            if (cell * double(text.size()) <= area.width() &&
                QFontMetricsF(font).height() <= area.height() * 1.25)
                break;
        }
        double x = area.x() + (area.width() - cell * double(text.size())) / 2;
        m_painter.setFont(font);
        for (qsizetype index = 0; index < text.size(); ++index, x += cell) {
            const QRectF box(x, area.y(), cell, area.height());
            if (index == edited) {
                const double height = std::min(area.height(), QFontMetricsF(font).height());
                m_painter.fillRect(QRectF(x, area.center().y() - height / 2, cell, height), amber);
            }
            m_painter.setPen(index == edited ? black : color);
            m_painter.drawText(box.adjusted(-cell, 0, cell, 0), Qt::AlignCenter, text.mid(index, 1));
        }
    }

private:
    int pixelSize(double dots) const { return std::max(1, int(std::lround(dots * m_dot))); }

    static bool fits(const QFont& font, const QRectF& area, int flags, const QString& text)
    {
        const QRectF needed = QFontMetricsF(font).boundingRect(area, flags, text);
        return needed.width() <= area.width() + 0.5 && needed.height() <= area.height() + 0.5;
    }

    /// Words without spaces are rather smaller on one line than broken anywhere.
    void draw(const QRectF& dots, const QString& text, QFont font, double size, int flags,
              const QColor& color)
    {
        constexpr double smallestUnbroken = 0.65;
        const QRectF area = place(dots);
        const int largest = pixelSize(size);
        const int unbroken = text.contains(u' ') ? largest : int(largest * smallestUnbroken);
        int pixels = largest;
        font.setPixelSize(pixels);
        while (pixels > unbroken && !fits(font, area, flags & ~Qt::TextWordWrap, text))
            font.setPixelSize(--pixels);
        while (pixels > 1 && !fits(font, area, flags, text))
            font.setPixelSize(--pixels);
        m_painter.setFont(font);
        m_painter.setPen(color);
        m_painter.drawText(area, flags, text);
    }

    QPainter& m_painter;
    QRectF m_rect;
    double m_dot;
    QFont m_words;
    QFont m_digits;
};

constexpr int toTheLeft = Qt::AlignLeft | Qt::AlignVCenter;
constexpr int toTheRight = Qt::AlignRight | Qt::AlignVCenter;
constexpr int inTheMiddle = Qt::AlignCenter;

struct Icon {
    bool on;
    double x;
    double width;
    QString text;
    QColor color;
};

/// Each icon has its place, lit or not.
void paintIcons(Canvas& canvas, const DisplayIcons& icons)
{
    const Icon upper[] = {{icons.laser, 2, 29, u"LASER"_s, green}, {icons.high, 33, 13, u"HI"_s, red},
                          {icons.go, 47, 15, u"GO"_s, green},      {icons.low, 63, 14, u"LO"_s, blue},
                          {icons.hold, 78, 24, u"HOLD"_s, amber},  {icons.zero, 103, 24, u"ZERO"_s, white}};
    for (const Icon& icon : upper) {
        if (!icon.on)
            continue;
        canvas.fill({icon.x, 2, icon.width, 11}, icon.color);
        canvas.words({icon.x, 2, icon.width, 11}, icon.text, 8.5, inTheMiddle, black, QFont::Bold);
    }
    canvas.words({3, 50, 20, 12}, icons.bank, 10, toTheLeft, white, QFont::DemiBold);
    canvas.words({26, 50, 24, 12}, icons.holdMode, 10, toTheLeft, amber, QFont::DemiBold);
}

void paintMeasurement(Canvas& canvas, const DisplayContent& content)
{
    paintIcons(canvas, content.icons);
    canvas.figures({2, 16, 124, 32}, withMinus(content.body), 28, -1, white);
    canvas.words({90, 50, 35, 12}, content.unit, 10, toTheRight, grey);
}

/// §2.2: the menu number, and one bar for each level.
void paintMenuPlace(Canvas& canvas, const DisplayContent& content)
{
    canvas.words({3, 1, 24, 12}, QString::number(content.menuNumber), 10, toTheLeft, white, QFont::DemiBold);
    constexpr int levels = 3;
    for (int level = 0; level < levels; ++level) {
        const QRectF bar(30 + level * 33, 5, 29, 4);
        if (level < content.hierarchyBars)
            canvas.fill(bar, white);
    }
    canvas.fill({2, 13.5, 124, 0.75}, grey);
}

/// A name above, a value below.
void paintTitled(Canvas& canvas, const DisplayContent& content)
{
    const bool hasNumber = content.menuNumber != 0;
    if (hasNumber)
        paintMenuPlace(canvas, content);
    const double top = hasNumber ? 15 : 3;
    canvas.words({3, top, 122, hasNumber ? 13.0 : 15.0}, content.title, hasNumber ? 10 : 11.5, toTheLeft,
                 white);
    const QRectF body(2, hasNumber ? 29 : 20, 124, hasNumber ? 22 : 28);
    if (content.screen == ScreenKind::Choice)
        canvas.words(body, content.body, 14, inTheMiddle, white, QFont::DemiBold);
    else
        canvas.figures(body, withMinus(content.body), hasNumber ? 20 : 25, content.edited, white);
    canvas.words({3, 51, 80, 12}, content.note, 10, toTheLeft, red, QFont::DemiBold);
    canvas.words({84, 51, 41, 12}, content.unit, 10, toTheRight, grey);
}

void paintMenu(Canvas& canvas, const DisplayContent& content)
{
    paintMenuPlace(canvas, content);
    canvas.words({4, 16, 120, 46}, content.body, 16, inTheMiddle, white, QFont::DemiBold);
}

/// What to set on one line, what to push on the next.
QString onTwoLines(QString prompt)
{
    qsizetype gap = prompt.indexOf(u" - "_s);
    if (gap < 0)
        gap = prompt.indexOf(u" and "_s);
    if (gap < 0)
        gap = prompt.lastIndexOf(u' ');
    return gap < 0 ? prompt : prompt.replace(gap, 1, u'\n');
}

void paintPrompt(Canvas& canvas, const DisplayContent& content)
{
    const bool hasValue = !content.body.isEmpty();
    canvas.words({4, 3, 120, hasValue ? 27.0 : 58.0}, onTwoLines(content.title), hasValue ? 11 : 13,
                 inTheMiddle, amber, QFont::DemiBold);
    canvas.figures({2, 31, 124, 20}, withMinus(content.body), 20, -1, white);
    canvas.words({90, 51, 35, 12}, content.unit, 10, toTheRight, grey);
}

void paintMessage(Canvas& canvas, const DisplayContent& content)
{
    canvas.words({4, 4, 120, 56}, content.body, 18, inTheMiddle, white, QFont::DemiBold);
}

void paintStartUp(Canvas& canvas, const DisplayContent& content)
{
    canvas.words({4, 8, 120, 30}, content.body, 26, inTheMiddle, white, QFont::Bold);
    canvas.words({4, 42, 120, 14}, content.note, 10, inTheMiddle, grey);
}

void paintScreen(Canvas& canvas, const DisplayContent& content)
{
    switch (content.screen) {
    case ScreenKind::StartUp:
        return paintStartUp(canvas, content);
    case ScreenKind::Measurement:
        return paintMeasurement(canvas, content);
    case ScreenKind::ReceivedLight:
    case ScreenKind::WindowValue:
    case ScreenKind::Choice:
    case ScreenKind::Entry:
        return paintTitled(canvas, content);
    case ScreenKind::Menu:
        return paintMenu(canvas, content);
    case ScreenKind::Prompt:
        return paintPrompt(canvas, content);
    case ScreenKind::Message:
        return paintMessage(canvas, content);
    }
}

bool isDark(const DisplayContent& content)
{
    return content.brightness == Brightness::Off || content.brightness == Brightness::Blink;
}

} // namespace

void paintDisplay(QPainter& painter, const QRectF& rect, const DisplayContent& content)
{
    painter.fillRect(rect, black);
    if (isDark(content))
        return;
    painter.save();
    painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
    painter.setClipRect(rect);
    if (content.inverted) {
        painter.translate(rect.center());
        painter.rotate(180);
        painter.translate(-rect.center());
    }
    if (content.brightness == Brightness::Dim)
        painter.setOpacity(dimmed);
    Canvas canvas(painter, rect, content.language);
    paintScreen(canvas, content);
    painter.restore();
}

QString spokenDisplay(const DisplayContent& content)
{
    if (content.brightness == Brightness::Off)
        return {};
    QStringList parts;
    if (content.menuNumber != 0)
        parts += QString::number(content.menuNumber);
    parts += content.title;
    parts += withMinus(content.body) + (content.unit.isEmpty() ? QString() : u' ' + content.unit);
    if (content.edited >= 0 && content.edited < content.body.size())
        parts += QCoreApplication::translate("PanelWidget", "editing character %1").arg(content.edited + 1);
    parts += content.note;
    if (content.screen == ScreenKind::Measurement) {
        const DisplayIcons& icons = content.icons;
        for (const auto& [on, name] : {std::pair(icons.laser, u"LASER"_s),
                                       {icons.high, u"HI"_s},
                                       {icons.go, u"GO"_s},
                                       {icons.low, u"LO"_s},
                                       {icons.hold, u"HOLD"_s},
                                       {icons.zero, u"ZERO"_s}}) {
            if (on)
                parts += name;
        }
        parts += icons.bank;
        parts += icons.holdMode;
    }
    parts.removeAll(QString());
    return parts.join(u", "_s);
}

} // namespace lds::emulator
