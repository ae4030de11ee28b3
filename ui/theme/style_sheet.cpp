#include "style_sheet.h"

#include "theme.h"

#include <QMap>

namespace lds::ui {

namespace {

// "@name" stands for a colour role. Sizes are pixels on the 4-pixel scale; text sizes are points so that
// they follow the screen's resolution.
constexpr auto sheet = R"(
* { outline: none; }
QToolTip { background: @panel; color: @text; border: 1px solid @line; padding: 4px 8px; }
QMainWindow::separator { background: @line; width: 1px; height: 1px; }
QMainWindow::separator:hover { background: @accent; }

QMenuBar { background: @panel; border-bottom: 1px solid @line; padding: 0 4px; }
QMenuBar::item { padding: 4px 8px; background: transparent; border-radius: 4px; }
QMenuBar::item:selected { background: @hover; }
QMenu { background: @panel; border: 1px solid @line; padding: 4px 0; }
QMenu::item { padding: 4px 24px 4px 8px; min-height: 18px; }
QMenu::icon { padding-left: 8px; }
QMenu::item:selected { background: @accentSoft; color: @text; }
QMenu::item:disabled { color: @muted; }
QMenu::separator { height: 1px; background: @line; margin: 4px 0; }

QPushButton { background: @panel; color: @text; border: 1px solid @line; border-radius: 4px;
              padding: 4px 10px; min-height: 18px; }
QPushButton:hover { background: @hover; }
QPushButton:pressed, QPushButton:checked { background: @accentSoft; border-color: @checkedLine; }
QPushButton:focus { border-color: @accent; }
QPushButton:disabled { color: @disabled; background: transparent; border-color: @grid; }
QPushButton[primary="true"] { background: @accent; color: @accentText; border-color: @accent; font-weight: 600; }
QPushButton[primary="true"]:hover { background: @accentHover; border-color: @accentHover; }
QPushButton[primary="true"]:focus { border: 2px solid @text; padding: 3px 9px; }
QPushButton[primary="true"]:disabled { background: @grid; color: @muted; border-color: @grid; font-weight: 400; }
QPushButton[quiet="true"] { background: transparent; border-color: transparent; }
QPushButton[quiet="true"]:hover { background: @hover; }
QPushButton[quiet="true"]:focus { border-color: @accent; }
QPushButton[quiet="true"]:checked { background: @accentSoft; border-color: @checkedLine; }
QToolButton { background: transparent; color: @text; border: 1px solid transparent; border-radius: 4px; padding: 3px 6px; }
QToolButton:hover { background: @hover; }
QToolButton:pressed, QToolButton:checked { background: @accentSoft; border-color: @checkedLine; }
QToolButton:focus { border-color: @accent; }
QToolButton:disabled { color: @disabled; }

QLineEdit, QSpinBox, QDoubleSpinBox, QAbstractSpinBox, QComboBox, QPlainTextEdit, QTextEdit {
    background: @panel; color: @text; border: 1px solid @control; border-radius: 3px;
    selection-background-color: @accent; selection-color: @accentText; }
QLineEdit, QAbstractSpinBox, QComboBox { padding: 2px 6px; min-height: 18px; }
QLineEdit:focus, QAbstractSpinBox:focus, QComboBox:focus, QPlainTextEdit:focus, QTextEdit:focus { border-color: @accent; }
QLineEdit[invalid="true"], QAbstractSpinBox[invalid="true"], QComboBox[invalid="true"] { border: 1px solid @error; }
QLineEdit:disabled, QAbstractSpinBox:disabled, QComboBox:disabled { color: @muted; background: @background; border-color: @line; }
QComboBox::drop-down { border: none; width: 20px; }
QComboBox::down-arrow { image: url(:/lds/sheet/chevron-down.svg); width: 12px; height: 12px; }
QComboBox QAbstractItemView { background: @panel; border: 1px solid @line; selection-background-color: @accentSoft;
                              selection-color: @text; padding: 2px; }
QAbstractSpinBox::up-button, QAbstractSpinBox::down-button { border: none; width: 16px; background: transparent; }
QAbstractSpinBox::up-button:hover, QAbstractSpinBox::down-button:hover { background: @hover; }
QAbstractSpinBox::up-arrow { image: url(:/lds/sheet/chevron-up.svg); width: 9px; height: 9px; }
QAbstractSpinBox::down-arrow { image: url(:/lds/sheet/chevron-down.svg); width: 9px; height: 9px; }
QCheckBox, QRadioButton { spacing: 6px; padding: 2px 0; }
QCheckBox::indicator, #scanFindings::indicator { width: 13px; height: 13px; border: 1px solid @controlStrong;
    border-radius: 3px; background: @panel; }
QCheckBox::indicator:hover, QCheckBox:focus::indicator { border-color: @accent; }
QCheckBox::indicator:checked, #scanFindings::indicator:checked { background: @accent; border-color: @accent; image: url(:/lds/sheet/check-@mode.svg); }
QCheckBox::indicator:disabled { background: @background; border-color: @line; }
QCheckBox:focus { color: @accent; }
QRadioButton::indicator { width: 13px; height: 13px; border: 1px solid @controlStrong; border-radius: 7px; background: @panel; }
QRadioButton::indicator:hover, QRadioButton:focus::indicator { border-color: @accent; }
QRadioButton::indicator:checked { width: 7px; height: 7px; border: 4px solid @accent; background: @panel; }
QRadioButton:focus { color: @accent; }
QCheckBox:disabled { color: @muted; }

QHeaderView { background: @panel; border: none; }
QHeaderView::section { background: @panel; color: @muted; border: none; border-bottom: 1px solid @line;
                       padding: 4px 8px; min-height: 20px; font-weight: 600; font-size: 8.25pt; }
QAbstractItemView { background: @panel; color: @text; border: none; alternate-background-color: @background;
                    selection-background-color: @accentSoft; selection-color: @text; gridline-color: @grid; }
QTableView QTableCornerButton::section { background: @panel; border: none; }

QTabWidget::pane { border: none; border-top: 1px solid @line; }
QTabBar { background: transparent; border: none; }
QTabBar::tab { background: transparent; color: @muted; padding: 4px 2px 7px 2px; margin-right: 20px;
               border: none; border-bottom: 2px solid transparent; }
QTabBar::tab:selected { color: @text; border-bottom: 2px solid @accent; }
QTabBar::tab:hover { color: @text; }
QTabBar::tab:focus { color: @accent; }

QStatusBar { background: @panel; border-top: 1px solid @line; color: @muted; }
QStatusBar::item { border: none; }
QDockWidget { background: @panel; }
QProgressBar { border: none; border-radius: 3px; background: @grid; min-height: 6px; max-height: 6px; }
QProgressBar::chunk { background: @accent; border-radius: 3px; }
QGroupBox { border: none; margin-top: 20px; font-weight: 600; }
QGroupBox::title { subcontrol-origin: margin; left: 0; }

QScrollBar { background: transparent; border: none; }
QScrollBar:vertical { width: 10px; }
QScrollBar:horizontal { height: 10px; }
QScrollBar::handle { background: @control; border-radius: 3px; margin: 2px; }
QScrollBar::handle:hover { background: @muted; }
QScrollBar::handle:vertical { min-height: 24px; }
QScrollBar::handle:horizontal { min-width: 24px; }
QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; border: none; }
QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }

QLabel[heading="true"] { color: @muted; font-size: 8.25pt; font-weight: 600; }
QLabel[title="true"] { font-size: 12pt; font-weight: 600; }
QLabel[muted="true"] { color: @muted; }
QLabel[error="true"] { color: @error; }
QFrame[separator="true"] { background: @line; border: none; }
#toolRow { background: @panel; border-bottom: 1px solid @line; }
#reviewTable::item, #scanFindings::item { padding: 0 8px; border: none; border-bottom: 1px solid @grid; }
#reviewTable::item:focus, #reviewTable::item:selected, #scanFindings::item:focus, #scanFindings::item:selected {
    background: @accentSoft; color: @text; }
*[card="true"] { background: @panel; border: 1px solid @line; border-radius: 6px; }
)";

QColor mixed(const QColor& a, const QColor& b, qreal part)
{
    return QColor::fromRgbF(float(a.redF() * (1 - part) + b.redF() * part),
                            float(a.greenF() * (1 - part) + b.greenF() * part),
                            float(a.blueF() * (1 - part) + b.blueF() * part));
}

} // namespace

QString styleSheet(const Theme& theme)
{
    const QColor text = theme.color(ColorRole::Text);
    const QColor panel = theme.color(ColorRole::Panel);
    const QColor line = theme.color(ColorRole::Line);
    const QColor accent = theme.color(ColorRole::Accent);
    const QColor muted = theme.color(ColorRole::Muted);
    // Longer names first, so that "@accentSoft" is not taken for "@accent".
    const QList<std::pair<QString, QString>> names{
        {QStringLiteral("@accentHover"), mixed(accent, text, 0.15).name()},
        {QStringLiteral("@accentText"), theme.color(ColorRole::AccentText).name()},
        {QStringLiteral("@accentSoft"), theme.color(ColorRole::AccentSoft).name()},
        {QStringLiteral("@accent"), accent.name()},
        {QStringLiteral("@checkedLine"), mixed(accent, theme.color(ColorRole::AccentSoft), 0.5).name()},
        {QStringLiteral("@background"), theme.color(ColorRole::Background).name()},
        {QStringLiteral("@panel"), panel.name()},
        {QStringLiteral("@line"), line.name()},
        {QStringLiteral("@grid"), theme.color(ColorRole::Grid).name()},
        {QStringLiteral("@text"), text.name()},
        {QStringLiteral("@muted"), muted.name()},
        {QStringLiteral("@disabled"), mixed(muted, panel, 0.35).name()},
        {QStringLiteral("@hover"), theme.color(ColorRole::Hover).name()},
        {QStringLiteral("@error"), theme.color(ColorRole::Error).name()},
        {QStringLiteral("@controlStrong"), mixed(line, text, 0.4).name()},
        {QStringLiteral("@control"), mixed(line, text, 0.12).name()},
        {QStringLiteral("@mode"), theme.isDark() ? QStringLiteral("dark") : QStringLiteral("light")},
    };
    QString result = QString::fromUtf8(sheet);
    for (const auto& [name, value] : names)
        result.replace(name, value);
    return result;
}

} // namespace lds::ui
