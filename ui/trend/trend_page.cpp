#include "trend_page.h"

#include "frame_pacer.h"
#include "theme.h"
#include "trend_chart.h"
#include "trend_notice.h"

#include <map>
#include <QComboBox>
#include <QFrame>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QVBoxLayout>

namespace lds::ui {

using sensor::SensorSession;

namespace {

constexpr int frameIntervalMs = 25;
constexpr qint64 second = 1'000'000'000;
constexpr qint64 allLength = 0; ///< The choice "All", TrendChart::setWindowLength().

} // namespace

struct TrendPage::Private {
    Private(TrendPage& page, ports::Scheduler& clock)
        : q(page)
        , scheduler(clock)
        , pacer(clock, &page, frameIntervalMs, [this] { frame(); })
    {}

    void build();
    QWidget* buildToolBar();
    void retranslate();
    void setSession(SensorSession* next);
    void sessionChanged(); ///< Limits, notice: what the plot says about the sensor.
    void viewChanged();    ///< Buttons and texts, and a frame.
    void measured();
    void frame();
    void requestFrame();
    void showControls();
    QString statusText();
    QString describe();
    TrendView* view();

    TrendPage& q;
    ports::Scheduler& scheduler;
    FramePacer pacer;
    QPointer<SensorSession> session;
    std::map<const SensorSession*, TrendView> views;
    bool dirty = true; ///< More than the pointer has moved.

    TrendChart* chart = nullptr;
    QPushButton* pause = nullptr;
    QPushButton* follow = nullptr;
    QPushButton* fit = nullptr;
    QComboBox* length = nullptr;
    QLabel* status = nullptr;
};

TrendPage::TrendPage(ports::Scheduler& scheduler, QWidget* parent)
    : QWidget(parent)
    , d(std::make_unique<Private>(*this, scheduler))
{
    d->build();
    d->retranslate();
    d->setSession(nullptr);
}

TrendPage::~TrendPage() = default;

void TrendPage::setSession(SensorSession* session) { d->setSession(session); }

TrendChart& TrendPage::chart() { return *d->chart; }

void TrendPage::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    d->sessionChanged();
    d->viewChanged();
}

/// The chart's keys work wherever on the page the focus is, save where a control needs them itself.
void TrendPage::keyPressEvent(QKeyEvent* event)
{
    const bool forwarded = event->key() == Qt::Key_F || event->key() == Qt::Key_End ||
                           event->key() == Qt::Key_Space || event->key() == Qt::Key_Plus ||
                           event->key() == Qt::Key_Minus;
    if (forwarded && !d->chart->hasFocus())
        d->chart->pressKey(event->key(), event->modifiers());
    else
        QWidget::keyPressEvent(event);
}

void TrendPage::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        d->retranslate();
        d->sessionChanged();
        d->viewChanged();
    }
}

void TrendPage::Private::build()
{
    auto* card = new QFrame(&q);
    card->setProperty("card", true);
    chart = new TrendChart(card);
    auto* line = new QFrame(card);
    line->setFixedHeight(1);
    line->setBackgroundRole(QPalette::Mid);
    line->setAutoFillBackground(true);

    auto* inside = new QVBoxLayout(card);
    inside->setContentsMargins(1, 0, 1, Theme::unit);
    inside->setSpacing(0);
    inside->addWidget(buildToolBar());
    inside->addWidget(line);
    inside->addWidget(chart, 1);
    auto* outside = new QVBoxLayout(&q);
    outside->setContentsMargins(0, 0, 0, 0);
    outside->addWidget(card);

    QObject::connect(chart, &TrendChart::viewChanged, &q, [this] { viewChanged(); });
    QObject::connect(chart, &TrendChart::pointerMoved, &q, [this] { requestFrame(); });
    QObject::connect(pause, &QPushButton::clicked, &q, [this](bool on) { chart->setPaused(on); });
    QObject::connect(follow, &QPushButton::clicked, &q, [this] { chart->follow(); });
    QObject::connect(fit, &QPushButton::clicked, &q, [this] { chart->fit(); });
    QObject::connect(length, &QComboBox::activated, &q,
                     [this](int index) { chart->setWindowLength(length->itemData(index).toLongLong()); });
}

QWidget* TrendPage::Private::buildToolBar()
{
    auto* bar = new QWidget(&q);
    pause = new QPushButton(bar);
    pause->setCheckable(true);
    follow = new QPushButton(Theme::instance().icon(QStringLiteral("follow")), {}, bar);
    follow->setCheckable(true);
    fit = new QPushButton(Theme::instance().icon(QStringLiteral("fit")), {}, bar);
    length = new QComboBox(bar);
    for (const qint64 ns : {1 * second, 10 * second, 60 * second, 600 * second, 3600 * second, allLength})
        length->addItem(QString(), ns);
    status = new QLabel(bar);
    status->setProperty("muted", true);
    status->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    status->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);

    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(2 * Theme::unit, Theme::unit, 3 * Theme::unit, Theme::unit);
    row->setSpacing(2 * Theme::unit);
    for (QWidget* widget : std::initializer_list<QWidget*>{pause, follow, fit, length})
        row->addWidget(widget);
    row->addWidget(status, 1);
    return bar;
}

void TrendPage::Private::retranslate()
{
    follow->setText(TrendPage::tr("Follow"));
    follow->setToolTip(TrendPage::tr("Jump to the newest value and stay there (End)"));
    fit->setText(TrendPage::tr("Fit"));
    fit->setToolTip(TrendPage::tr("Show everything measured so far, with all its values (F)"));
    length->setToolTip(TrendPage::tr("How much time is shown. The mouse wheel, + and − zoom in and out."));
    length->setAccessibleName(TrendPage::tr("Time shown"));
    for (int index = 0; index < length->count(); ++index) {
        const qint64 ns = length->itemData(index).toLongLong();
        length->setItemText(index, ns == allLength ? TrendPage::tr("All") : durationText(ns));
    }
    // The button keeps its width when its word changes.
    const auto widthOf = [this](const QString& text) {
        pause->setText(text);
        return pause->sizeHint().width();
    };
    pause->setIcon(Theme::instance().icon(QStringLiteral("pause")));
    pause->setMinimumWidth(std::max(widthOf(TrendPage::tr("Pause")), widthOf(TrendPage::tr("Go on"))));
}

void TrendPage::Private::setSession(SensorSession* next)
{
    if (session)
        session->disconnect(&q);
    session = next;
    if (session) {
        const auto about = [this] { sessionChanged(); };
        QObject::connect(session, &SensorSession::connectionChanged, &q, about);
        QObject::connect(session, &SensorSession::readinessChanged, &q, about);
        QObject::connect(session, &SensorSession::identityChanged, &q, about);
        QObject::connect(session, &SensorSession::pendingChanged, &q, about);
        QObject::connect(session, &SensorSession::heldChanged, &q, about);
        QObject::connect(session, &SensorSession::measured, &q, [this] { measured(); });
        const bool known = views.count(next) > 0;
        if (!known) // once for each session, whichever is looked at then
            QObject::connect(session, &QObject::destroyed, chart, [this, next] {
                if (view() == &views[next] || session.isNull())
                    chart->setSource(nullptr, nullptr);
                views.erase(next);
                sessionChanged();
            });
        chart->setSource(&session->trend(), &views[next]);
    } else {
        chart->setSource(nullptr, nullptr);
    }
    sessionChanged();
    viewChanged();
}

void TrendPage::Private::sessionChanged()
{
    if (session)
        chart->setDecimals(std::max(2, session->catalog().model(session->model()).decimals));
    chart->setLimits(session ? limitsOf(*session) : TrendLimits());
    chart->setNotice(noticeFor(session));
    chart->setAccessibleDescription(describe());
}

void TrendPage::Private::viewChanged()
{
    dirty = true;
    showControls();
    requestFrame();
}

void TrendPage::Private::measured()
{
    if (!q.isVisible())
        return;
    chart->setNotice(noticeFor(session));
    if (!chart->wantsFrame())
        return;
    dirty = true;
    requestFrame();
}

void TrendPage::Private::requestFrame()
{
    if (q.isVisible() && !q.window()->isMinimized())
        pacer.request();
}

void TrendPage::Private::frame()
{
    if (!q.isVisible())
        return;
    if (!dirty) {
        chart->viewport()->update();
        return;
    }
    dirty = false;
    chart->updateFrame(scheduler.nowNs());
    if (const TrendView* shown = view(); shown && shown->values.narrowsAtNs()) {
        dirty = true;
        pacer.requestAt(*shown->values.narrowsAtNs());
    }
    status->setText(statusText());
}

void TrendPage::Private::showControls()
{
    const TrendView* shown = view();
    for (QWidget* control : std::initializer_list<QWidget*>{pause, follow, fit, length})
        control->setEnabled(shown != nullptr);
    if (!shown) {
        length->setCurrentIndex(length->findData(TrendTimeWindow().lengthNs()));
        status->clear();
        return;
    }
    const bool paused = shown->time.isPaused();
    pause->setChecked(paused);
    pause->setText(paused ? TrendPage::tr("Go on") : TrendPage::tr("Pause"));
    pause->setIcon(Theme::instance().icon(paused ? QStringLiteral("play") : QStringLiteral("pause")));
    pause->setToolTip(paused ? TrendPage::tr("Let the view move again (Space)")
                             : TrendPage::tr("Hold the view still while values keep arriving (Space)"));
    follow->setChecked(shown->time.isFollowing() && !paused);
    const qint64 chosen = shown->time.showsAll() ? allLength : shown->time.lengthNs();
    length->setPlaceholderText(durationText(chosen));
    length->setCurrentIndex(length->findData(chosen));
    chart->setAccessibleDescription(describe());
}

QString TrendPage::Private::statusText()
{
    const TrendView* shown = view();
    if (!shown || !chart->scene().hasData)
        return {};
    const qint64 endNs = std::min(chart->scene().scale.span.toNs, session->trend().lastNs());
    QStringList parts;
    if (shown->time.isPaused())
        parts += TrendPage::tr("Paused; values keep arriving");
    else if (!shown->time.isFollowing())
        parts += TrendPage::tr("Looking back, up to %1")
                     .arg(clockText(endNs + chart->scene().wallOffsetNs, second));
    if (!shown->values.isAutomatic())
        parts += TrendPage::tr("value axis set by hand");
    if (parts.isEmpty())
        return {};
    return parts.join(QStringLiteral(" · "));
}

/// For a screen reader: what the picture shows, in one go; changes with the view, not with the values.
QString TrendPage::Private::describe()
{
    const TrendView* shown = view();
    if (!shown)
        return noticeFor(session).title;
    QStringList parts;
    parts += shown->time.showsAll() ? TrendPage::tr("Everything measured so far")
                                    : TrendPage::tr("%1 shown").arg(durationText(shown->time.lengthNs()));
    parts += shown->time.isPaused()      ? TrendPage::tr("paused")
             : shown->time.isFollowing() ? TrendPage::tr("following the newest value")
                                         : TrendPage::tr("looking back");
    if (session) {
        const TrendLimits limits = limitsOf(*session);
        for (const TrendLimit* limit : {&limits.high, &limits.low}) {
            if (limit->held)
                parts += limit->heldText + QStringLiteral(" mm");
        }
        const TrendNotice notice = noticeFor(session);
        if (!notice.isEmpty())
            parts += notice.title;
    }
    return parts.join(QStringLiteral(", "));
}

TrendView* TrendPage::Private::view()
{
    const auto found = views.find(session.data());
    return session && found != views.end() ? &found->second : nullptr;
}

} // namespace lds::ui
