#include "theme.h"

#include "line_icon.h"
#include "style_sheet.h"

#include <QApplication>
#include <QFile>
#include <QFontDatabase>
#include <QPalette>
#include <QSettings>
#include <QStyleFactory>

// A static library's resources are linked only when they are asked for; the macro must stand outside
// every namespace.
static void initResources() { Q_INIT_RESOURCE(resources); }

namespace lds::ui {

namespace {

struct Shade {
    QRgb light;
    QRgb dark;
};

Shade shade(ColorRole role)
{
    switch (role) {
    case ColorRole::Background:
        return {0xfff4f5f7, 0xff14181d};
    case ColorRole::Panel:
        return {0xffffffff, 0xff1c2229};
    case ColorRole::Line:
        return {0xffdcdfe4, 0xff323a44};
    case ColorRole::Text:
        return {0xff1c2430, 0xffe8edf3};
    case ColorRole::Muted:
        return {0xff5b6675, 0xff9aa6b4};
    case ColorRole::Accent:
        return {0xff1f5fbf, 0xff6ea8ff};
    case ColorRole::AccentText:
        return {0xffffffff, 0xff0b0f14};
    case ColorRole::AccentSoft:
        return {0xffe5eefb, 0xff22344f};
    case ColorRole::Edit:
        return {0xfffff6d6, 0xff3a3214};
    case ColorRole::EditBar:
        return {0xffd69e00, 0xffe0b33a};
    case ColorRole::High:
        return {0xffb93815, 0xffff8a66};
    case ColorRole::Go:
        return {0xff1f7a3d, 0xff62cf87};
    case ColorRole::Low:
        return {0xff1556a8, 0xff7db4ff};
    case ColorRole::Warning:
        return {0xff8a5c00, 0xffe3b341};
    case ColorRole::Error:
        return {0xffb3261e, 0xffff8a80};
    case ColorRole::Grid:
        return {0xffe7eaee, 0xff2a323b};
    case ColorRole::Series:
        return {0xff1f5fbf, 0xff6ea8ff};
    case ColorRole::Band:
        return {0x141f7a3d, 0x1862cf87};
    case ColorRole::Hover:
        return {0xffeceff3, 0xff262e37};
    case ColorRole::DisplayBackground:
        return {0xff0b0f14, 0xff0b0f14};
    case ColorRole::Display:
        return {0xfff2f6fb, 0xfff2f6fb};
    case ColorRole::DisplayDim:
        return {0xff76828f, 0xff76828f};
    case ColorRole::DisplayLine:
        return {0xff27313c, 0xff27313c};
    case ColorRole::DisplayLaser:
        return {0xff62cf87, 0xff62cf87};
    case ColorRole::DisplayLit:
        return {0xffcfd8e3, 0xffcfd8e3};
    case ColorRole::DisplayMuted:
        return {0xff9fb0c3, 0xff9fb0c3};
    case ColorRole::DisplayMeter:
        return {0xff8bb8ff, 0xff8bb8ff};
    case ColorRole::DisplayWarning:
        return {0xffe3b341, 0xffe3b341};
    case ColorRole::DisplayHigh:
        return {0xffc2410c, 0xffc2410c};
    case ColorRole::DisplayGo:
        return {0xff1f7a3d, 0xff1f7a3d};
    case ColorRole::DisplayLow:
        return {0xff1d5fc0, 0xff1d5fc0};
    case ColorRole::DisplayGoText:
        return {0xffffffff, 0xffffffff};
    }
    return {0xffff00ff, 0xffff00ff};
}

bool systemPrefersDark(const QApplication& application)
{
#ifdef Q_OS_WIN
    // Qt 6.4 does not tell on Windows.
    const QSettings personalize(
        QStringLiteral(
            "HKEY_CURRENT_USER\\Software\\Microsoft\\Windows\\CurrentVersion\\Themes\\Personalize"),
        QSettings::NativeFormat);
    return personalize.value(QStringLiteral("AppsUseLightTheme"), 1).toInt() == 0;
#else
    const QPalette palette = application.palette();
    return palette.color(QPalette::Window).lightness() < palette.color(QPalette::WindowText).lightness();
#endif
}

QStringList families()
{
    return {QStringLiteral("Noto Sans"),        QStringLiteral("Segoe UI"),
            QStringLiteral("Noto Sans CJK JP"), QStringLiteral("Yu Gothic UI"),
            QStringLiteral("Noto Sans CJK SC"), QStringLiteral("Microsoft YaHei UI"),
            QStringLiteral("DejaVu Sans")};
}

QPalette paletteOf(const Theme& theme)
{
    const auto c = [&theme](ColorRole role) { return theme.color(role); };
    QPalette palette(c(ColorRole::Text), c(ColorRole::Panel), c(ColorRole::Line), c(ColorRole::Line),
                     c(ColorRole::Muted), c(ColorRole::Text), c(ColorRole::Panel));
    palette.setColor(QPalette::Window, c(ColorRole::Background));
    palette.setColor(QPalette::AlternateBase, c(ColorRole::Background));
    palette.setColor(QPalette::BrightText, c(ColorRole::Error));
    palette.setColor(QPalette::ToolTipBase, c(ColorRole::Panel));
    palette.setColor(QPalette::ToolTipText, c(ColorRole::Text));
    palette.setColor(QPalette::PlaceholderText, c(ColorRole::Muted));
    palette.setColor(QPalette::Highlight, c(ColorRole::Accent));
    palette.setColor(QPalette::HighlightedText, c(ColorRole::AccentText));
    palette.setColor(QPalette::Link, c(ColorRole::Accent));
    palette.setColor(QPalette::LinkVisited, c(ColorRole::Accent));
    palette.setColor(QPalette::Light, c(ColorRole::Panel));
    palette.setColor(QPalette::Midlight, c(ColorRole::Grid));
    palette.setColor(QPalette::Mid, c(ColorRole::Line));
    palette.setColor(QPalette::Dark, c(ColorRole::Muted));
    palette.setColor(QPalette::Shadow, c(ColorRole::Line));
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        palette.setColor(QPalette::Disabled, role, c(ColorRole::Muted));
    palette.setColor(QPalette::Disabled, QPalette::Highlight, c(ColorRole::Line));
    palette.setColor(QPalette::Disabled, QPalette::HighlightedText, c(ColorRole::Text));
    return palette;
}

} // namespace

Theme& Theme::instance()
{
    static Theme theme;
    return theme;
}

void Theme::apply(QApplication& application, ThemeMode mode)
{
    initResources();
    if (!m_application)
        m_systemIsDark = systemPrefersDark(application); // before our own palette hides it
    m_application = &application;
    m_mode = mode;
    application.setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    QFont font;
    font.setFamilies(families());
    font.setPointSizeF(9.75); // 13 px at 96 dpi
    application.setFont(font);
    refresh();
}

void Theme::setMode(ThemeMode mode)
{
    if (m_mode == mode)
        return;
    m_mode = mode;
    refresh();
}

void Theme::refresh()
{
    m_dark = m_mode == ThemeMode::Dark || (m_mode == ThemeMode::System && m_systemIsDark);
    if (m_application) {
        m_application->setPalette(paletteOf(*this));
        m_application->setStyleSheet(styleSheet(*this));
    }
    Q_EMIT changed();
}

QColor Theme::color(ColorRole role) const
{
    const Shade both = shade(role);
    return QColor::fromRgba(m_dark ? both.dark : both.light);
}

QIcon Theme::icon(const QString& name) const { return icon(name, ColorRole::Text); }

QIcon Theme::icon(const QString& name, ColorRole role) const
{
    const QString path = QStringLiteral(":/lds/icons/%1.svg").arg(name);
    return QFile::exists(path) ? QIcon(new LineIcon(path, role)) : QIcon();
}

QFont Theme::numberFont(int pointSize, bool bold) const
{
    QFont font; // Noto Sans' and Segoe UI's figures are tabular, in the bold weight too
    font.setFamilies(families());
    font.setPointSize(pointSize);
    font.setBold(bold);
    return font;
}

QFont Theme::displayFont(int pixelSize) const
{
    QFont font;
    font.setFamilies({QStringLiteral("Noto Sans Mono"), QStringLiteral("DejaVu Sans Mono"),
                      QStringLiteral("Consolas"), QStringLiteral("Menlo")});
    font.setStyleHint(QFont::Monospace);
    font.setPixelSize(pixelSize);
    font.setWeight(QFont::Medium);
    return font;
}

} // namespace lds::ui
