#include "readout.h"

#include "readout_painter.h"
#include "readout_state.h"
#include "theme.h"

#include <QBasicTimer>
#include <QPainter>
#include <QPointer>
#include <QTimerEvent>

namespace lds::ui {

using sensor::SensorSession;

namespace {
constexpr int refreshIntervalMs = 66; ///< Faster than this nobody reads digits.
constexpr int readoutHeight = 88;
} // namespace

struct Readout::Private {
    QPointer<SensorSession> session;
    ReadoutState state;
    QBasicTimer pacer; ///< Runs while measurements may come faster than they can be read.
    bool waiting = false;
};

Readout::Readout(QWidget* parent)
    : QWidget(parent)
    , d(std::make_unique<Private>())
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setAccessibleName(tr("Measured value"));
    setObjectName(QStringLiteral("readout"));
    connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
    refresh();
}

Readout::~Readout() = default;

void Readout::setSession(SensorSession* session)
{
    if (d->session)
        d->session->disconnect(this);
    d->session = session;
    if (session) {
        connect(session, &SensorSession::measured, this, &Readout::refreshSoon);
        connect(session, &SensorSession::connectionChanged, this, &Readout::refresh);
        connect(session, &SensorSession::readinessChanged, this, &Readout::refresh);
        connect(session, &SensorSession::heldChanged, this, &Readout::refreshSoon);
        connect(session, &SensorSession::identityChanged, this, &Readout::refreshSoon);
        connect(session, &QObject::destroyed, this, [this] { setSession(nullptr); });
    }
    refresh();
}

QSize Readout::sizeHint() const { return {1004, readoutHeight}; }
QSize Readout::minimumSizeHint() const { return {640, readoutHeight}; }
QString Readout::spokenText() const { return lds::ui::spokenText(d->state); }
const ReadoutState& Readout::state() const { return d->state; }

void Readout::refreshSoon()
{
    if (d->pacer.isActive()) {
        d->waiting = true;
        return;
    }
    refresh();
    d->pacer.start(refreshIntervalMs, this);
}

void Readout::timerEvent(QTimerEvent* event)
{
    if (event->timerId() != d->pacer.timerId())
        return QWidget::timerEvent(event);
    if (d->waiting)
        refresh();
    else
        d->pacer.stop();
}

void Readout::refresh()
{
    d->waiting = false;
    d->state = readoutState(d->session);
    setToolTip(d->state.notice); // in full, where the readout has little room
    const QString words = spokenText();
    if (words != accessibleDescription())
        setAccessibleDescription(words);
    update();
}

void Readout::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    paintReadout(&painter, rect(), d->state, font());
}

} // namespace lds::ui
