#include "panel_widget.h"

#include "display_view.h"
#include "indicator_lamp.h"
#include "key_button.h"

#include <QFrame>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

namespace lds::emulator {

using namespace Qt::StringLiterals;

namespace {

const QColor laserGreen(0x3d, 0xdc, 0x84);
const QColor alarmOrange(0xff, 0x93, 0x2e);

/// As they are printed in the manual, in every language.
QString nameOf(Key key)
{
    switch (key) {
    case Key::Up:
        return u"UP"_s;
    case Key::Enter:
        return u"ENTER"_s;
    case Key::Down:
        return u"DOWN"_s;
    }
    return {};
}

std::optional<Key> keyOf(const QKeyEvent& event)
{
    switch (event.key()) {
    case Qt::Key_Up:
        return Key::Up;
    case Qt::Key_Down:
        return Key::Down;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        return Key::Enter;
    default:
        return {};
    }
}

quintptr holderOf(const QKeyEvent& event) { return quintptr(event.key()); }
quintptr holderOf(const QObject* button) { return quintptr(button); }

} // namespace

PanelWidget::PanelWidget(QWidget* parent)
    : QWidget(parent)
{
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Sensor front panel"));
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(makeCase());
    layout->addWidget(makePairRow());
    layout->addStretch();
    nameKeys();
}

QWidget* PanelWidget::makeCase()
{
    auto* face = new QFrame(this);
    face->setObjectName(u"sensorCase"_s);
    face->setStyleSheet(
        u"#sensorCase { background: #1c2026; border: 1px solid #39414c; border-radius: 10px; }"_s);
    auto* layout = new QVBoxLayout(face);
    layout->setContentsMargins(14, 10, 14, 12);
    layout->setSpacing(10);

    auto* lamps = new QHBoxLayout;
    m_laser = new IndicatorLamp(tr("Laser radiation"), laserGreen, face);
    m_alarm = new IndicatorLamp(tr("Alarm"), alarmOrange, face);
    lamps->addWidget(m_laser);
    lamps->addStretch();
    lamps->addWidget(m_alarm);
    layout->addLayout(lamps);
    m_display = new DisplayView(face);
    layout->addWidget(m_display);
    layout->addWidget(makeKeyRow());
    return face;
}

QWidget* PanelWidget::makeKeyRow()
{
    auto* row = new QWidget(this);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    for (const Key key : {Key::Up, Key::Enter, Key::Down}) {
        auto* button = new KeyButton(row);
        button->installEventFilter(this);
        connect(button, &KeyButton::heldChanged, this, [this, button, key](bool held) {
            if (held)
                hold(holderOf(button), {key});
            else
                letGo(holderOf(button));
        });
        m_keys[std::size_t(key)] = button;
        layout->addWidget(button);
    }
    return row;
}

QWidget* PanelWidget::makePairRow()
{
    auto* row = new QWidget(this);
    auto* layout = new QVBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    auto* pairs = new QHBoxLayout;
    addPair(pairs, Key::Up, Key::Down,
            tr("Holds UP and DOWN together: briefly for zero set, in an entry back to the first digit; two "
               "seconds lock or unlock the keys"));
    addPair(pairs, Key::Down, Key::Enter, tr("Holds DOWN and ENTER together: zero set off"));
    addPair(pairs, Key::Up, Key::Enter, tr("Holds UP and ENTER together: resets the measured value"));
    layout->addLayout(pairs);
    auto* power = new QPushButton(tr("Power off and on"), row);
    power->setObjectName(u"power"_s);
    power->setToolTip(tr("Switches the sensor's power off and on. With ENTER held for two seconds "
                         "meanwhile, the set values are initialized"));
    power->setAccessibleName(tr("Switch the sensor off and on"));
    power->setAutoDefault(false);
    power->setFocusPolicy(Qt::TabFocus);
    power->installEventFilter(this);
    connect(power, &QPushButton::clicked, this, &PanelWidget::powerCycleRequested);
    layout->addWidget(power, 0, Qt::AlignRight);
    return row;
}

void PanelWidget::addPair(QBoxLayout* row, Key first, Key second, const QString& tip)
{
    auto* button = new QToolButton(this);
    // Where tool buttons are flat it would look like a word.
    button->setStyleSheet(
        u"QToolButton { border: 1px solid palette(mid); border-radius: 4px; padding: 3px 6px; }"_s);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    button->setObjectName(u"%1+%2"_s.arg(nameOf(first), nameOf(second)));
    button->setText(button->objectName());
    button->setToolTip(tip);
    button->setAccessibleName(tr("%1 and %2 keys together").arg(nameOf(first), nameOf(second)));
    button->setFocusPolicy(Qt::TabFocus);
    button->installEventFilter(this);
    connect(button, &QToolButton::pressed, this, [this, button, first, second] {
        hold(holderOf(button), {keyAt(first), keyAt(second)});
    });
    connect(button, &QToolButton::released, this, [this, button] { letGo(holderOf(button)); });
    row->addWidget(button);
}

const DisplayContent& PanelWidget::content() const { return m_display->content(); }

void PanelWidget::showContent(const DisplayContent& content)
{
    m_display->showContent(content);
    m_laser->showState(content.laserIndicator);
    m_alarm->showState(content.alarmIndicator);
    nameKeys();
}

Key PanelWidget::keyAt(Key named) const
{
    if (!content().inverted || named == Key::Enter)
        return named;
    return named == Key::Up ? Key::Down : Key::Up;
}

void PanelWidget::nameKeys()
{
    for (const Key name : {Key::Up, Key::Enter, Key::Down}) {
        KeyButton* button = m_keys[std::size_t(keyAt(name))];
        if (button->text() == nameOf(name))
            continue;
        button->setText(nameOf(name));
        button->setAccessibleName(tr("%1 key").arg(nameOf(name)));
        const QString shortcut = name == Key::Up     ? tr("Up arrow")
                                 : name == Key::Down ? tr("Down arrow")
                                                     : tr("Return");
        button->setToolTip(
            tr("%1 key (%2 on the keyboard). Right-click to keep it pressed").arg(nameOf(name), shortcut));
    }
}

// Holding

void PanelWidget::hold(quintptr holder, const QList<Key>& keys)
{
    letGo(holder);
    m_holders.insert(holder, keys);
    for (const Key key : keys) {
        if (m_holdCount[std::size_t(key)]++ == 0)
            Q_EMIT keyPressed(key);
    }
}

void PanelWidget::letGo(quintptr holder)
{
    for (const Key key : m_holders.take(holder)) {
        if (--m_holdCount[std::size_t(key)] == 0)
            Q_EMIT keyReleased(key);
    }
}

void PanelWidget::letGoOfKeyboard()
{
    for (const Qt::Key key : {Qt::Key_Up, Qt::Key_Down, Qt::Key_Return, Qt::Key_Enter})
        letGo(quintptr(key));
}

bool PanelWidget::pressedOnKeyboard(QKeyEvent* event)
{
    const auto key = keyOf(*event);
    if (!key)
        return false;
    if (!event->isAutoRepeat())
        hold(holderOf(*event), {keyAt(*key)});
    return true;
}

bool PanelWidget::releasedOnKeyboard(QKeyEvent* event)
{
    if (!keyOf(*event))
        return false;
    if (!event->isAutoRepeat())
        letGo(holderOf(*event));
    return true;
}

/// The buttons inside take the space bar for themselves and leave the sensor's keys to the panel.
bool PanelWidget::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::KeyPress)
        return pressedOnKeyboard(static_cast<QKeyEvent*>(event));
    if (event->type() == QEvent::KeyRelease)
        return releasedOnKeyboard(static_cast<QKeyEvent*>(event));
    if (event->type() == QEvent::FocusOut)
        letGoOfKeyboard();
    return QWidget::eventFilter(watched, event);
}

void PanelWidget::keyPressEvent(QKeyEvent* event)
{
    if (!pressedOnKeyboard(event))
        QWidget::keyPressEvent(event);
}

void PanelWidget::keyReleaseEvent(QKeyEvent* event)
{
    if (!releasedOnKeyboard(event))
        QWidget::keyReleaseEvent(event);
}

void PanelWidget::focusOutEvent(QFocusEvent* event)
{
    letGoOfKeyboard();
    QWidget::focusOutEvent(event);
}

void PanelWidget::hideEvent(QHideEvent* event)
{
    for (KeyButton* key : m_keys)
        key->unlatch();
    const auto holders = m_holders.keys();
    for (const quintptr holder : holders)
        letGo(holder);
    QWidget::hideEvent(event);
}

} // namespace lds::emulator
