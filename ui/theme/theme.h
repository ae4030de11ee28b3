#pragma once

#include <QColor>
#include <QFont>
#include <QIcon>
#include <QObject>

class QApplication;

namespace lds::ui {

/// The palette of both themes. Nothing in ui/ names a colour by its number.
enum class ColorRole {
    Background,
    Panel,
    Line,
    Text,
    Muted,
    Accent,
    AccentText,
    AccentSoft,
    Edit,
    EditBar, ///< A pending edit's row and the bar at its edge.
    High,
    Go,
    Low,
    Warning,
    Error,
    DisplayBackground,
    Display,
    DisplayDim,
    DisplayLine,
    DisplayLaser,
    DisplayLit, ///< The readout: dark in both themes.
    Grid,
    Series,
    Band,
    // The readout, continued: also the same in both themes.
    DisplayMuted, ///< Small words beside the value: unit, rate, received light.
    DisplayMeter,
    DisplayWarning,
    DisplayHigh,
    DisplayGo,
    DisplayLow,
    DisplayGoText,
    Hover, ///< Under the pointer.
};

enum class ThemeMode { System, Light, Dark };

/// One for the program. Applies palette, style sheet and fonts to the application; widgets that paint for
/// themselves ask color() when painting and repaint on changed().
///
/// The style sheet knows these dynamic properties, set before the widget is shown:
///   QPushButton "primary" = true     the one blue button
///   QPushButton "quiet" = true       no frame until hovered
///   QLabel "heading" = true          small capitals-like section heading, muted
///   QLabel "title" = true            a page's or pane's title
///   QLabel "muted" = true            secondary text
///   QFrame, QWidget "card" = true    panel with a rounded line around it
class Theme final : public QObject {
    Q_OBJECT

public:
    static Theme& instance();

    void apply(QApplication& application, ThemeMode mode);
    void setMode(ThemeMode mode);
    ThemeMode mode() const { return m_mode; }
    bool isDark() const { return m_dark; }
    QColor color(ColorRole role) const;

    /// A line icon of resources/icons by name ("connect", "save", ...), drawn in the text colour of the
    /// moment: it follows a change of theme by itself. A null icon when there is none of that name.
    QIcon icon(const QString& name) const;
    QIcon icon(const QString& name, ColorRole role) const;
    /// Tabular figures for numbers that stand under each other.
    QFont numberFont(int pointSize, bool bold = false) const;
    /// The display's figures: all of one width, sign and point included.
    QFont displayFont(int pixelSize) const;

    static constexpr int unit = 4; ///< The spacing scale: multiples of 4 pixels.

Q_SIGNALS:
    void changed();

private:
    Theme() = default;
    void refresh();

    QApplication* m_application = nullptr;
    ThemeMode m_mode = ThemeMode::System;
    bool m_dark = false;
    bool m_systemIsDark = false;
};

inline QColor color(ColorRole role) { return Theme::instance().color(role); }

} // namespace lds::ui
