#pragma once

#include "display_content.h"
#include "panel_key.h"

#include <array>
#include <optional>
#include <QHash>
#include <QList>
#include <QWidget>

class QBoxLayout;

namespace lds::emulator {

class DisplayView;
class IndicatorLamp;
class KeyButton;

/// The face of the sensor: its two indicators, its display, its three keys, and below them buttons for two
/// keys at once and for the power. It knows no sensor: connect its signals to a FrontPanel and the panel's
/// contentChanged() to showContent(), queued when they live in different threads.
///
/// The keys are named by what they do now, so that the outer two change names while the display is
/// inverted (§4.8.3); keyPressed() and keyReleased() tell the place. On the keyboard Up, Return (or Enter)
/// and Down are the keys of that name, several at a time.
class PanelWidget final : public QWidget {
    Q_OBJECT

public:
    explicit PanelWidget(QWidget* parent = nullptr);

    const DisplayContent& content() const;

public Q_SLOTS:
    void showContent(const lds::emulator::DisplayContent& content);

Q_SIGNALS:
    void keyPressed(lds::emulator::Key key);
    void keyReleased(lds::emulator::Key key);
    void powerCycleRequested();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    QWidget* makeCase();
    QWidget* makeKeyRow();
    QWidget* makePairRow();
    void addPair(QBoxLayout* row, Key first, Key second, const QString& tip);
    Key keyAt(Key named) const; ///< The place of the key that has this name now.
    void nameKeys();
    bool pressedOnKeyboard(QKeyEvent* event);
    bool releasedOnKeyboard(QKeyEvent* event);
    void hold(quintptr holder, const QList<Key>& keys);
    void letGo(quintptr holder);
    void letGoOfKeyboard();

    DisplayView* m_display = nullptr;
    IndicatorLamp* m_laser = nullptr;
    IndicatorLamp* m_alarm = nullptr;
    std::array<KeyButton*, keyCount> m_keys{};
    QHash<quintptr, QList<Key>> m_holders; ///< A button's address or a keyboard key, and what it holds.
    std::array<int, keyCount> m_holdCount{};
};

} // namespace lds::emulator
